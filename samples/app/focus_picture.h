// Depth of field on a picture: under one table of it, or in layers of depth.
#pragma once

#include <string>
#include <vector>

#include "runtime/passes/depth_of_field.h"
#include "samples/app/light.h"
#include "samples/app/stats.h"
#include "samples/files/picture.h"

namespace boxcar {

struct FocusRequest {
    Lens lens;
    float largestTexels = 1;  // circle of confusion
    uint32_t boxes = 16;      // that stand for it
    uint32_t sides = 0;       // of an aperture with so many blades; 0: round
    uint32_t taps = 4;
};

// Returns the focused texels, as of ToLight, RGBA. Sums are whole numbers fine enough for `result` (FittingCodes).
//
//   name       of the picture, for messages
//   disparity  RGBA texels of the picture's extent with 1 / distance in alpha, in the lens's units
//   result     the samples of the file to write
//   stats      what the device did is added to it
//
// Throws Error as FittingCodes and DepthOfField do.
std::vector<glm::vec4> FocusPicture(Device& device, const Picture& picture, const std::string& name,
                                    Transfer transfer, const FocusRequest& request,
                                    const std::vector<glm::vec4>& disparity, SampleType result, Stats& stats);

// The same in layers of depth, which do not bleed into each other (layered_depth_of_field.h). Light is summed in
// steps of Stats::step, 2^-20 for 8-bit results and 2^-28 for others.
//
// Throws Error, which begins with `name`: a picture with alpha, or brighter than kBrightestLensLight.
std::vector<glm::vec4> FocusPictureByLayers(Device& device, const Picture& picture, const std::string& name,
                                            Transfer transfer, const FocusRequest& request,
                                            const std::vector<glm::vec4>& disparity, SampleType result, Stats& stats);

}  // namespace boxcar
