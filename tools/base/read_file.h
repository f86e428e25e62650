// Files in: whole, and never more than the caller is ready for.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace boxcar {

struct ReadFileOptions {
    std::string name;                                          // what messages call the file
    uint64_t maxBytes = std::numeric_limits<uint64_t>::max();  // a longer file is an Error, so an endless one ends
    std::function<void(std::span<const uint8_t>)> checkStart = {};  // sees the first bytes (at least 16, or all) and
                                                                    // throws what it does not want to be read
};

// Reads a file, device or pipe to its end.
//
// Throws Error, "NAME: .." with the reason: it cannot be opened or read, is a folder, is longer than `maxBytes`, or
// does not fit into memory.
std::vector<uint8_t> ReadFile(const std::string& path, const ReadFileOptions& options);

// The same from where an open descriptor stands. It stays open.
std::vector<uint8_t> ReadDescriptor(int descriptor, const ReadFileOptions& options);

}  // namespace boxcar
