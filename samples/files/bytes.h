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

// Whether writing to `path` writes to standard output: "-", or a name or link that ends there, such as /dev/stdout.
bool IsStandardOutput(const std::string& path);

// Writes `bytes` to `path` whole, or leaves it as it was, but for the few kinds of path that
// tools/base/output_file.h names; it also says what becomes of links, owners and permissions. "-" is standard
// output. A signal that ends the process leaves no temporary file.
void WriteFileAtomically(const std::string& path, ByteView bytes);

}  // namespace boxcar
