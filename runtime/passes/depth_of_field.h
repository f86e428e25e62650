// Depth of field on a picture whose distances are known: each texel becomes the mean over its own circle of
// confusion.
//
//   disparity  ->  LensWidths  ->  widths
//   color      ->  Blur, by the widths  ->  picture
//
// One table of the whole picture, as the papers have it: what is in focus bleeds into what is not behind it, because
// a circle there takes in texels of other distances. layered_depth_of_field.h does without.
//
// Hensley 2005, sect. 5.4 (Fig. 9)
#pragma once

#include "runtime/passes/blur.h"

namespace boxcar {

struct Lens {
    float focusDisparity = 0.5f;  // 1 / distance of what is sharp, in the disparity's units
    float apertureTexels = 40;    // diameter of the circle of confusion for a disparity that differs by 1
};

// The circle of confusion of every texel, as a map of widths for SATFilter. Device memory: 16 bytes a texel.
// Move-only.
class LensWidths {
public:
    //   largestTexels  the largest circle to come; larger ones become this
    LensWidths(Device& device, Extent2D extent, float largestTexels);

    //   disparity  RGBA32F; alpha is 1 / distance in any unit
    SATWidths Record(CommandList& commands, const Image& disparity, const Lens& lens);

private:
    float m_largestTexels;
    Pipeline m_pipeline;
    Image m_widths;
};

struct DepthOfFieldDesc {
    Extent2D extent = {};       // texels
    uint32_t taps = 4;          // texels added per pass while the table is built: 2, 4, 8 or 16
    uint32_t boxes = 16;        // of equal height, that stand for a circle
    uint32_t sides = 0;         // of an aperture with so many blades, 3 to 16; 0: round
    float largestTexels = 256;  // the largest circle to come; larger ones become this
    // U32 or U64: what is in focus stays as it is. A table of floats over a megapixel makes it noisy by a per cent.
    SATPrecision precision = SATPrecision::U64;
    SATCodes codes = {};
};

// Device memory: that of Blur and 16 bytes a texel. Move-only. Not thread-safe.
class DepthOfField {
public:
    // Throws Error as Blur does.
    DepthOfField(Device& device, const DepthOfFieldDesc& desc);

    // Returns the picture, RGBA32F.
    //
    //   color      linear light times alpha, as of SummedAreaTable::Record
    //   disparity  RGBA32F of the same extent; alpha is 1 / distance in any unit
    const Image& Record(CommandList& commands, TexelWords color, const Image& disparity, const Lens& lens);

private:
    LensWidths m_widths;
    Blur m_blur;
};

}  // namespace boxcar
