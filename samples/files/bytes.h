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

// Writes `bytes` to `path` whole, or leaves it as it was: they go to a new file in the same folder, which then takes
// the name. A link stays, and what it points to is written. A file that is replaced hands on its owner, group and
// permissions; its access control lists, extended attributes and other hard links stay with the old bytes.
//
// Written directly, so that a failure in the midst leaves a part:
//   "-", /dev/stdout, /dev/fd/N, ..  the descriptor as it is: where it stands, at the end if it was opened to append
//   no regular file                  a FIFO, a device such as /dev/null
//   a file whose folder takes no     over its old bytes; what cannot be kept by a new file (above) is kept. A disk
//   new one, or no new one that has  that is full is noticed before the first of them is lost, where the file system
//   the same owner and permissions   can tell
//
// A signal that ends the process leaves no temporary file (tools/layout/temporary_file.h).
void WriteFileAtomically(const std::string& path, ByteView bytes);

}  // namespace boxcar
