// Maps of depth for the lens.
#pragma once

#include <vector>

#include "runtime/format.h"

namespace boxcar {

// Gives every texel of 0, whose depth is unknown, the value of the nearest that is known; of several as near, one of
// them. Without any known texel nothing is done.
//
// Cost: linear in the number of texels. Felzenszwalb and Huttenlocher 2012, "Distance Transforms of Sampled
// Functions"
void FillUnknown(std::vector<float>& disparity, Extent2D extent);

// 1 / distance, so that the nearest known becomes 1; 0, which is unknown, stays.
void DistanceToDisparity(std::vector<float>& distance);

}  // namespace boxcar
