#include "tools/bxc/commands/limits.h"

namespace boxcar {

using Values = std::span<const std::string>;

const char* const kLimitFlagsHelp = R"(
  --timeout SECONDS   a compile that takes longer is stopped; 60 by default
  --max-memory MIB    a compile that needs more memory is stopped; 1024 by default
)";

std::vector<Flag> LimitFlags(WorkerLimits& limits) {
    return {
        {"--timeout", 1, [&](Values v) { limits.timeoutSeconds = ParseNumber("--timeout", v[0], 1, 86400); }},
        {"--max-memory", 1, [&](Values v) { limits.maxMemoryMib = ParseNumber("--max-memory", v[0], 64, 1 << 20); }},
    };
}

}  // namespace boxcar
