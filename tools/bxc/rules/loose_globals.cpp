// A constant outside a cbuffer. The compiler collects these in a buffer named $Global, whose order and offsets differ
// by stage and from Direct3D's.
#include <set>

#include "tools/bxc/rules.h"

namespace boxcar::rules::loose_globals {

void Check(const RuleSubject& shader, const RuleSubject*, Diagnostics& diagnostics) {
    std::set<std::string> told;
    for (const LayoutResource& resource : shader.declared.resources) {
        if (resource.name != "$Global") continue;
        for (const LayoutMember& member : resource.members) {
            const std::string name = member.name.substr(0, member.name.find('.'));  // of a struct: its variable
            if (!told.insert(name).second) continue;
            diagnostics.push_back({shader.outline.Global(name), Severity::Error,
                                   fmt::format("'{}' is a constant outside a cbuffer; put it into a named cbuffer "
                                               "with a register, or make it static const",
                                               name)});
        }
    }
}

}  // namespace boxcar::rules::loose_globals
