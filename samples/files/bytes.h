// Whole files, in and out. All errors are boxcar::Error, one line that begins with the path and ends with the
// system's reason.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace boxcar {

using Bytes = std::vector<uint8_t>;
using ByteView = std::span<const uint8_t>;

// How messages call a path: "-" is standard input, or output.
std::string InputName(const std::string& path);
std::string OutputName(const std::string& path);

// Reads `path` ("-": standard input) to its end.
//
//   maxBytes    a longer input is an Error, so an endless one ends here
//   checkStart  sees the first bytes (at least 16, or all) and throws what it does not want before the rest is read
Bytes ReadBytes(const std::string& path, uint64_t maxBytes, const std::function<void(ByteView)>& checkStart);

// Writes `bytes` to `path` whole, or leaves it as it was: they go to a new file in the same folder, which then takes
// the name. "-" is standard output; it and what is no regular file (/dev/null, a FIFO) are written directly. A file
// that is replaced hands on its permissions; a link stays, and what it points to is replaced.
void WriteFileAtomically(const std::string& path, ByteView bytes);

}  // namespace boxcar
