// Constants of the third-order filters' shaders: one text for HLSL and C++. Order the members so that none crosses a
// 16-byte line; SharedConstants.EveryStructIsTheBlockOfAShader compares them with the compiled shaders.
#ifndef BOXCAR_BSPLINE_CONSTANTS_H
#define BOXCAR_BSPLINE_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// bspline_prefilter.ps: along one axis.
struct BSplinePrefilterConstants
{
    int2 stepTexels;  // (1, 0) or (0, 1)
};

// bspline_weights.ps
struct BSplineWeightsConstants
{
    float points;  // of the curve, from one texel to the next
};

// resize.ps: along one axis.
struct ResizeConstants
{
    float stepTexels;  // of the source, from one texel of the result to the next
    int alongX;
};

// bspline_lookup.ps
struct BSplineLookupConstants
{
    int sizeTexels;     // of the lookup texture
    float sigmaTexels;  // of the Gaussian
};

#ifdef __cplusplus
}
#endif

#endif
