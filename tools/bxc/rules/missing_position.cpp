// A vertex shader that gives the rasteriser no position. POSITION0 is an ordinary output, not the position.
#include "tools/bxc/rules.h"

#include <algorithm>

namespace boxcar::rules::missing_position {

void Check(const RuleInput& input, Diagnostics& diagnostics) {
    const CompiledShader& shader = input.shader;
    if (shader.stage != ShaderStage::Vertex || !shader.hasEntry) return;
    const auto semantic = [&](std::string_view name) {
        return std::ranges::find(shader.outputs, name, &DeclaredVariable::semantic);
    };
    if (semantic("SV_POSITION0") != shader.outputs.end()) return;

    SourcePlace place = shader.entryPlace;
    std::string hint;
    if (const auto old = semantic("POSITION0"); old != shader.outputs.end()) {
        place = old->place;
        hint = fmt::format("; '{}' : POSITION0 is an ordinary output", old->name);
    }
    diagnostics.push_back({place, Severity::Error, fmt::format("'{}' writes no SV_Position{}", shader.entry, hint)});
}

}  // namespace boxcar::rules::missing_position
