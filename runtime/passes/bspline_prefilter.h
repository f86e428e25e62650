// Makes the cubic B-spline of an image go through its texels.
//
//   source  ->  along x  ->  along y  ->  coefficients
//
// The spline smooths what it is given; of these coefficients it gives back the source (hlsl/boxcar/bspline.hlsli).
//
// Beyond Sigg 2005
#pragma once

#include "runtime/command_list.h"

namespace boxcar {

enum class Axis { X, Y };

// Along one axis. Holds one pipeline and one image: 16 bytes of device memory a texel. Move-only. Not thread-safe.
class BSplinePrefilter {
public:
    BSplinePrefilter(Device& device, Extent2D extent, Axis axis);

    // Returns the coefficients, RGBA32F. The image goes on as its mirror image. Error: 1e-6 of the largest texel.
    // Cost: 29 loads a texel.
    const Image& Record(CommandList& commands, const Image& source);

private:
    Axis m_axis;
    Pipeline m_pipeline;
    Image m_coefficients;
};

}  // namespace boxcar
