// The entry point does not exist. The compiler warns and makes an empty module.
#include "tools/bxc/rules.h"

namespace boxcar::rules::missing_entry {

void Check(const RuleInput& input, Diagnostics& diagnostics) {
    if (!input.shader.hasEntry)
        diagnostics.push_back({input.shader.entryPlace, Severity::Error,
                               fmt::format("there is no function '{}' to enter", input.shader.entry)});
}

}  // namespace boxcar::rules::missing_entry
