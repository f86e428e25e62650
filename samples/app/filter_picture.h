// A picture filtered on the device: values -> codes or light -> bands of rows -> table -> filtered rows.
#pragma once

#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/passes/blur.h"
#include "samples/app/codes.h"
#include "samples/app/stats.h"
#include "samples/app/tell.h"

namespace boxcar {

struct FilterRequest {
    uint32_t order = 1;      // 1 box, 2 tent, 3 parabolic
    uint32_t boxes = 1;      // that stand for a disc or a polygon; 1 for a box. Order 1 only
    uint32_t sides = 0;      // of the polygon; 0 for a disc
    glm::vec2 minTexels{1};  // of the box that the kernel is made of; the same twice without a map
    glm::vec2 maxTexels{1};
    SATEdge edge = SATEdge::Clip;
    uint32_t taps = 4;
    std::optional<SATPrecision> precision = {};  // none: integers that hold the kernel (FittingCodes)
    std::optional<BlurBias> bias = {};           // FP32 only; none: of the mean, for 8 and 16-bit pictures
    SATOrigin origin = SATOrigin::Corner;        // FP32 only
};

// Returns the filtered texels, as of ToLight, RGBA.
//
//   name      of the picture, for messages
//   widthMap  RGBA texels of the picture's extent, whose red is 0 for the least width and 1 for the largest; or none
//   result    the samples of the file to write
//   stats     what the device did is added to it
//   tell      hears one line where texels ask for wider sums than a named precision holds and become NaN, and one
//             where floats may be off by more than half a code
//
// Throws Error: a kernel that the words do not hold; sums of floats that end in
// infinity; what the device cannot hold.
std::vector<glm::vec4> FilterPicture(Device& device, const Picture& picture, const std::string& name,
                                     Transfer transfer, const FilterRequest& request,
                                     const std::vector<glm::vec4>& widthMap, SampleType result, Stats& stats,
                                     const Tell& tell);

// The most that a filtered texel of a table of floats is off, in the picture's values (README; SATSumBox in
// hlsl/boxcar/sat.hlsli).
//
//   texels   of the picture, as of ToLight
//   request  its widths, edge, and boxes of a disc
//   bias     taken off before the texels are summed
double FloatTableBound(const std::vector<glm::vec4>& texels, Extent2D extent, const FilterRequest& request,
                       BlurBias bias);

}  // namespace boxcar
