// The entry point does not exist. The compiler warns and makes an empty module.
#include "tools/bxc/rules.h"

namespace boxcar::rules::missing_entry {

void Check(const RuleSubject& shader, const RuleSubject*, Diagnostics& diagnostics) {
    if (!shader.compiled.hasEntry)
        diagnostics.push_back({shader.EntryPlace(), Severity::Error,
                               fmt::format("there is no entry point '{}'", shader.options.entry)});
}

}  // namespace boxcar::rules::missing_entry
