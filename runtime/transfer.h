// Texels to the device and back. Both wait until the copy is done.
#pragma once

#include <cstddef>
#include <span>

#include "runtime/image.h"

namespace boxcar {

// `texels`: rows from the top, of a volume slice by slice, tightly packed, exactly as many bytes as the texels have.
// Large images go in bands of rows, and volumes in slices, through a staging buffer of at most 64 MiB.
void WriteTexels(Device& device, const Image& image, std::span<const std::byte> texels);
void ReadTexels(Device& device, const Image& image, std::span<std::byte> texels);

}  // namespace boxcar
