// A vertex shader that gives the rasterizer no position. POSITION0 is an ordinary output, not the position.
#include <algorithm>

#include "tools/bxc/rules.h"

namespace boxcar::rules::missing_position {

void Check(const RuleSubject& shader, const RuleSubject*, Diagnostics& diagnostics) {
    if (shader.options.stage != ShaderStage::Vertex || !shader.compiled.hasEntry || shader.declared.writesPosition)
        return;

    diagnostics.push_back(
        {shader.EntryPlace(), Severity::Error, fmt::format("'{}' does not write SV_Position", shader.options.entry)});
    const auto old = std::ranges::find(shader.declared.outputs, "POSITION0", &LayoutVariable::semantic);
    if (old != shader.declared.outputs.end())
        diagnostics.push_back({shader.outline.Output(shader.options.entry, old->name), Severity::Note,
                               "POSITION is an ordinary output, not the position"});
}

}  // namespace boxcar::rules::missing_position
