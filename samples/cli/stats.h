// What a command did on the device, for people (--stats) and programs (--json).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/device.h"
#include "runtime/format.h"
#include "runtime/timing.h"

namespace boxcar {

struct Stats {
    std::string input;
    std::string output;
    Extent2D extent = {};
    std::string precision = {};  // "fp32", "u32", "u64", or empty where no table was needed
    uint64_t tableBytes = 0;     // of device memory: 32 a texel for fp32 and u32, 64 for u64
    std::string volume = {};     // which file, and what was read of it; empty where none was
    std::vector<PassTime> passes = {};
    uint64_t deviceBytes = 0;  // at the most, while this picture was worked on
};

// {"input", "output", "width", "height", "precision", "table_bytes", "device_bytes", "device_ms",
// "passes": [{"name", "ms"}]}
nlohmann::ordered_json ToJson(const Stats& stats);

// To stderr, so that a picture may go to stdout.
void PrintStats(const Stats& stats, const DeviceInfo& device);

}  // namespace boxcar
