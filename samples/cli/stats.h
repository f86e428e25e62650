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
    double step = 0;             // of integers: what was summed are whole multiples of it, in the picture's values
    size_t rounds = 1;           // of integers: tables that were added up to make one result
    uint64_t tableBytes = 0;     // of device memory: 32 a texel for fp32 and u32, 64 for u64
    std::string volume = {};     // which file, and what was read of it; empty where none was
    std::vector<PassTime> passes = {};
    uint64_t deviceBytes = 0;  // at the most, while this picture was worked on
};

// {"input", "output", "width", "height", "precision", "step", "rounds", "table_bytes", "device_bytes", "device_ms",
// "passes": [{"name", "ms"}]}; precision and step are null where no table was needed.
nlohmann::ordered_json ToJson(const Stats& stats);

// Adds what passes of the same name took.
void AddTimes(std::vector<PassTime>& total, const std::vector<PassTime>& times);

// To stderr, so that a picture may go to stdout.
void PrintStats(const Stats& stats, const DeviceInfo& device);

}  // namespace boxcar
