// The limits of a compile, which every command that compiles takes.
#pragma once

#include <vector>

#include "tools/bxc/flags.h"
#include "tools/bxc/workers.h"

namespace boxcar {

// --timeout and --max-memory, which write to `limits`. It must outlive the flags.
std::vector<Flag> LimitFlags(WorkerLimits& limits);

// The flags and what they mean, for HelpText.
extern const char* const kLimitFlagsHelp;

}  // namespace boxcar
