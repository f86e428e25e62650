// An image at another size. The center of texel x of the result lies (x + 0.5) steps behind the source's edge.
//
//   source  ->  [prefilter]  ->  resize.ps  ->  [prefilter]  ->  along x, and then the same along y
//
// The kernel is as wide as a texel of the source, or of the result where that is larger: so nothing aliases. The
// interpolating spline's prefilter stands on the side of the larger texels.
//
// Sigg 2005 (filters)
#pragma once

#include <optional>
#include <vector>

#include "hlsl/constants/bspline_constants.h"
#include "runtime/passes/bspline_prefilter.h"

namespace boxcar {

enum class ResizeFilter {
    Nearest,
    Linear,
    BSpline,               // smooths
    InterpolatingBSpline,  // goes through the texels
    CatmullRom,            // goes through the texels, by fewer of them
};

struct ResizeDesc {
    Extent2D source = {};
    Extent2D result = {};
    float2 stepTexels = {};  // of the source, from one texel of the result to the next; above 0
    ResizeFilter filter = ResizeFilter::InterpolatingBSpline;
};

// Holds an image of the result's width and the source's height, one of the result, and the prefilter's: 16 bytes of
// device memory a texel each. Move-only. Not thread-safe.
class Resize {
public:
    Resize(Device& device, const ResizeDesc& desc);

    // Returns the result, RGBA32F. The edge texel goes on outside. Cost: along each axis 2 (linear) or 4 loads a
    // texel of the result where that is larger, of the source where it is smaller.
    const Image& Record(CommandList& commands, const Image& source);

private:
    struct AxisPasses {
        ResizeConstants constants;
        std::optional<BSplinePrefilter> before, after;
        Image result;
    };

    Pipeline m_pipeline;
    std::vector<AxisPasses> m_axes;
};

}  // namespace boxcar
