// Texel formats and extents.
#pragma once

#include <cstdint>

namespace boxcar {

struct Extent2D {
    uint32_t widthTexels = 0;
    uint32_t heightTexels = 0;

    uint64_t Texels() const { return uint64_t{widthTexels} * heightTexels; }
    bool operator==(const Extent2D&) const = default;
};

enum class Format { RGBA32F, RGBA16F, RGBA8, R32F, RGBA32UI, Depth32F };

uint32_t BytesPerTexel(Format format);

// "RGBA32F", ..
const char* FormatName(Format format);

}  // namespace boxcar
