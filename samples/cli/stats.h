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
    Extent2D extent;
    std::vector<PassTime> passes;
    uint64_t deviceBytes = 0;  // at the most, while this picture was worked on
};

// {"input", "output", "width", "height", "device_bytes", "device_ms", "passes": [{"name", "ms"}]}
nlohmann::ordered_json ToJson(const Stats& stats);

// To stderr, so that a picture may go to stdout.
void PrintStats(const Stats& stats, const DeviceInfo& device);

}  // namespace boxcar
