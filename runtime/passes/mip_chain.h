// An image with its mip levels, each made of the one before.
//
//   source  ->  half as large, level by level  ->  copied into one image of all levels
#pragma once

#include <vector>

#include "runtime/command_list.h"

namespace boxcar {

// Holds one pipeline, all levels, and those below the first once more: 1.7 times the image's memory. Move-only. Not
// thread-safe.
class MipChain {
public:
    // Each texel of a level is the plain mean of those that it lies over.
    MipChain(Device& device, Extent2D extent);

    // halve: makes a level of `finer`, an image-to-image pass.
    MipChain(Device& device, Extent2D extent, const PipelineDesc& halve);

    // Returns the image of all levels, RGBA32F.
    const Image& Record(CommandList& commands, const Image& source);

private:
    Pipeline m_halve;
    Image m_all;
    std::vector<Image> m_levels;  // from the second on
};

}  // namespace boxcar
