// Maps of depth for the lens.
#pragma once

#include <vector>

#include "runtime/format.h"

namespace boxcar {

// Gives every texel of NaN, whose depth is unknown, the value of the nearest that is known; of several as near, one
// of them. False: none is known, and nothing is done.
//
// Cost: linear in the number of texels. Felzenszwalb and Huttenlocher 2012, "Distance Transforms of Sampled
// Functions"
bool FillUnknown(std::vector<float>& depth, Extent2D extent);

}  // namespace boxcar
