// Makes the lookup texture of a third-order filter's kernel.
//
//   one pass, sizeTexels x 1: x and y how far off the two linear fetches lie, z the second one's share
//
// hlsl/boxcar/bspline_lookup.hlsli reads it; docs/third-order.md has what sizes and formats cost.
//
// Sigg 2005, sect. 20.2 and 20.6
#pragma once

#include "runtime/command_list.h"

namespace boxcar {

enum class BSplineKernel { Value, FirstDerivative, Gaussian, GaussianFirstDerivative };

struct BSplineLookupDesc {
    BSplineKernel kernel = BSplineKernel::Value;
    uint32_t sizeTexels = 128;
    Format format = Format::RGBA32F;  // RGBA16F; RGBA8 too for the spline, all of whose offsets and shares are 0 to 1
    float sigmaTexels = 0.5f;         // of a Gaussian, 0.3 to 0.8
};

// Holds one pipeline and one image. Move-only. Not thread-safe.
class BSplineLookup {
public:
    // Throws Error: a size below 2 or over the device's limit; a Gaussian in RGBA8, or one that four texels do not
    // hold.
    BSplineLookup(Device& device, const BSplineLookupDesc& desc);

    const Image& Record(CommandList& commands);

private:
    BSplineLookupDesc m_desc;
    Pipeline m_pipeline;
    Image m_lookup;
};

}  // namespace boxcar
