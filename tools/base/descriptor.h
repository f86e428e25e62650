#pragma once

#include <cstddef>
#include <span>

namespace boxcar {

// Writes all of `bytes`, in as many calls of write(2) as it takes; waits for a pipe that does not block. False: errno
// says why not.
bool WriteAll(int descriptor, std::span<const std::byte> bytes);

}  // namespace boxcar
