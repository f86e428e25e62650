// Two resources that the entry point uses on one register. The compiler binds both to the same place and says
// nothing.
#include "tools/bxc/rules.h"

#include <limits>

namespace boxcar::rules::binding_clash {
namespace {

// One past the last binding that a resource takes. Direct3D gives every element of an array its own register.
uint64_t End(const DeclaredResource& resource) {
    return resource.count == 0 ? std::numeric_limits<uint64_t>::max() : uint64_t{resource.binding} + resource.count;
}

// "t3", "b0, space1"
std::string Register(uint32_t set, uint32_t binding) {
    const auto [letter, base] = binding >= 96   ? std::pair('t', 96u)
                                : binding >= 32 ? std::pair('u', 32u)
                                : binding >= 16 ? std::pair('s', 16u)
                                                : std::pair('b', 0u);
    return set == 0 ? fmt::format("{}{}", letter, binding - base)
                    : fmt::format("{}{}, space{}", letter, binding - base, set);
}

}  // namespace

void Check(const RuleInput& input, Diagnostics& diagnostics) {
    const std::vector<DeclaredResource>& resources = input.shader.resources;
    for (size_t i = 0; i < resources.size(); ++i)
        for (size_t j = 0; j < i; ++j) {
            const DeclaredResource &late = resources[i], &early = resources[j];
            if (!late.used || !early.used || late.set != early.set) continue;
            if (late.binding >= End(early) || early.binding >= End(late)) continue;
            diagnostics.push_back(
                {late.place, Severity::Error,
                 fmt::format("'{}' is on register({}) with '{}' (line {} of {}); give it one of its own", late.name,
                             Register(late.set, std::max(late.binding, early.binding)), early.name, early.place.line,
                             early.place.file)});
        }
}

}  // namespace boxcar::rules::binding_clash
