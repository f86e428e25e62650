// The mean of an image, through a mip chain on the device.
//
//   source, W x H  ->  sums of 2 x 2, level by level  ->  mean, 1 x 1
//
// Hensley 2005, sect. 4.2.1
#pragma once

#include <vector>

#include "runtime/command_list.h"

namespace boxcar {

// Holds one pipeline and the levels: a third of the image's memory. Move-only. Not thread-safe.
class Mean {
public:
    Mean(Device& device, Extent2D extent);

    // Returns an image of one texel, RGBA32F. A 1 x 1 source is its own mean: then the source itself is returned.
    // Error: the sum is a tree of depth d = ceil(log2 W) + ceil(log2 H), so 2 d u of the mean of the magnitudes.
    const Image& Record(CommandList& commands, const Image& source);

private:
    Extent2D m_extent;
    Pipeline m_pipeline;
    std::vector<Image> m_levels;
};

}  // namespace boxcar
