// Two resources that the entry point uses on one register. The compiler binds both to the same place and says
// nothing.
#include <limits>

#include "tools/bxc/rules.h"
#include "tools/layout/registers.h"

namespace boxcar::rules::binding_clash {
namespace {

// One past the last binding that a resource takes. Direct3D gives every element of an array its own register.
uint64_t End(const LayoutResource& resource) {
    return resource.count == 0 ? std::numeric_limits<uint64_t>::max() : uint64_t{resource.binding} + resource.count;
}

// "register(t3)", "register(b0, space1)"; with shifts of the user's own, "binding 3 of set 0"
std::string Place(uint32_t set, uint32_t binding, const CompileOptions& options) {
    if (!options.shifts.empty()) return fmt::format("binding {} of set {}", binding, set);
    const auto [registerClass, number] = RegisterAt(binding);
    return set == 0 ? fmt::format("register({}{})", registerClass, number)
                    : fmt::format("register({}{}, space{})", registerClass, number, set);
}

}  // namespace

void Check(const RuleSubject& shader, const RuleSubject*, Diagnostics& diagnostics) {
    const std::vector<LayoutResource>& resources = shader.used.resources;
    for (const LayoutResource& late : resources)
        for (const LayoutResource& early : resources) {
            if (&early == &late) break;
            const bool haveBindings =
                early.kind != ResourceKind::PushConstants && late.kind != ResourceKind::PushConstants;
            if (!haveBindings || early.set != late.set || late.binding >= End(early)) continue;
            diagnostics.push_back({shader.outline.Global(late.name), Severity::Error,
                                   fmt::format("'{}' is on {}, where '{}' is", late.name,
                                               Place(late.set, late.binding, shader.options), early.name)});
            diagnostics.push_back({shader.outline.Global(early.name), Severity::Note,
                                   fmt::format("'{}' is declared here", early.name)});
        }
}

}  // namespace boxcar::rules::binding_clash
