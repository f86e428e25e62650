// Blurs an image with a box of any size, at a cost that does not depend on it.
//
//   source  ->  SummedAreaTable  ->  BoxFilter  ->  blurred
//
// Crow 1984; Hensley 2005
#pragma once

#include "runtime/passes/box_filter.h"
#include "runtime/passes/summed_area_table.h"

namespace boxcar {

struct BoxBlurDesc {
    Extent2D extent;    // texels
    uint32_t taps = 4;  // texels added per pass while the table is built: 2, 4, 8 or 16
    BoxEdge edge = BoxEdge::Clip;
    // Taken off before and added back after, in the source's units. The mean of a photograph makes the rounding of
    // float32 some 10 to 100 times smaller; for HDR leave it 0 (Hensley 2005, sect. 4.2.1).
    glm::vec4 bias{0};
};

// 48 bytes of device memory per texel. Move-only. Not thread-safe.
class BoxBlur {
public:
    // Throws Error as SummedAreaTable does.
    BoxBlur(Device& device, const BoxBlurDesc& desc);

    // `sizeTexels`: full width and height of the box, any real; below 1 acts as 1. Returns the blurred image,
    // RGBA32F.
    const Image& Record(CommandList& commands, const Image& source, glm::vec2 sizeTexels);

    // Passes of building the table.
    uint32_t TablePasses() const { return m_table.Passes(); }

private:
    SummedAreaTable m_table;
    BoxFilter m_filter;
};

}  // namespace boxcar
