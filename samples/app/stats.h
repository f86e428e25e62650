// What was done on the device for one picture.
#pragma once

#include <string>
#include <vector>

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
    uint64_t deviceBytes = 0;  // at most, while this picture was worked on
};

// Adds what passes of the same name took.
void AddTimes(std::vector<PassTime>& total, const std::vector<PassTime>& times);

}  // namespace boxcar
