// Texels and bytes to the device and back. All wait until the copy is done.
#pragma once

#include <cstddef>
#include <span>

#include "runtime/image.h"
#include "runtime/storage_buffer.h"

namespace boxcar {

// `texels`: rows from the top, of a volume slice by slice, tightly packed, exactly as many bytes as the texels have.
// Large images go in bands of rows, and volumes in slices, through a staging buffer of at most 64 MiB.
void WriteTexels(Device& device, const Image& image, std::span<const std::byte> texels);
void ReadTexels(Device& device, const Image& image, std::span<std::byte> texels);

// `bytes`: exactly as many as the buffer has. Through a staging buffer of at most 64 MiB, too.
void WriteBytes(Device& device, const StorageBuffer& buffer, std::span<const std::byte> bytes);
void ReadBytes(Device& device, const StorageBuffer& buffer, std::span<std::byte> bytes);

}  // namespace boxcar
