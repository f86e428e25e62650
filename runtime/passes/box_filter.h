// The mean over a box round every texel, read from a summed-area table.
//
//   table, W x H  ->  one pass  ->  filtered image, W x H
//
// Crow 1984, sect. 2.1; Hensley 2005, sect. 2
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "runtime/command_list.h"

namespace boxcar {

enum class BoxEdge {
    Clip,  // the box is clipped to the image and divided by the area that is left: a constant stays constant
    Zero,  // the image is 0 outside and the whole box divides: coverage fades at the rim
};

struct BoxFilterDesc {
    Extent2D extent;  // texels; of the table and of the result
    BoxEdge edge = BoxEdge::Clip;
    glm::vec4 bias{0};  // that of the table
};

// Holds one pipeline and the result: 16 bytes of device memory per texel. Move-only. Not thread-safe.
class BoxFilter {
public:
    // Throws Error: extent is 0 or over the device's limit.
    BoxFilter(Device& device, const BoxFilterDesc& desc);

    // `sizeTexels`: full width and height of the box, any real; below 1 acts as 1. Returns the filtered image,
    // RGBA32F, readable by shaders up to the next Record() on the same object.
    const Image& Record(CommandList& commands, const Image& table, glm::vec2 sizeTexels);

private:
    BoxFilterDesc m_desc;
    Pipeline m_pipeline;
    Image m_result;
};

}  // namespace boxcar
