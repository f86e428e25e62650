// A constant outside a cbuffer. The compiler collects these in a buffer named $Global, whose order and offsets differ
// by stage and from Direct3D's.
#include "tools/bxc/rules.h"

namespace boxcar::rules::loose_globals {

void Check(const RuleInput& input, Diagnostics& diagnostics) {
    for (const DeclaredName& constant : input.shader.looseGlobals)
        diagnostics.push_back({constant.place, Severity::Error,
                               fmt::format("'{}' is a constant outside a cbuffer; put it into a named cbuffer with a "
                                           "register, or make it static const",
                                           constant.name)});
}

}  // namespace boxcar::rules::loose_globals
