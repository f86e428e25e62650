// A compute shader that does not say how many threads its group has. The compiler takes one; Direct3D's refuse it.
#include <algorithm>
#include <array>

#include "tools/bxc/rules.h"

namespace boxcar::rules::missing_numthreads {

void Check(const RuleSubject& shader, const RuleSubject*, Diagnostics& diagnostics) {
    if (shader.options.stage != ShaderStage::Compute || !shader.compiled.hasEntry) return;
    const auto isOne = [](uint32_t size) { return size == 1; };
    const bool isGiven =
        !std::ranges::all_of(shader.declared.threadGroup, isOne) ||
        std::ranges::any_of(std::to_array({"numthreads", "NumThreads", "NUMTHREADS"}),
                            [&](const char* name) { return !shader.outline.Mentions(name).empty(); });
    if (!isGiven)
        diagnostics.push_back({shader.EntryPlace(), Severity::Error,
                               fmt::format("'{}' has no [numthreads(x, y, z)]", shader.options.entry)});
}

}  // namespace boxcar::rules::missing_numthreads
