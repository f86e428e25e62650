// Constants of the summed-area table's shaders: one text for HLSL and C++. Order the members so that none crosses a
// 16-byte line; PassesConstants.OffsetsInCppEqualThoseInTheShaders compares them with the compiled shaders.
#ifndef BOXCAR_SAT_CONSTANTS_H
#define BOXCAR_SAT_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// sat_bias.ps: what comes before the first pass when there is a bias.
struct SATBiasConstants
{
    float4 bias;  // taken off every texel, in the source's units
};

// sat_pass.vs, sat_pass_load.ps: one pass of building the table.
struct SATPassConstants
{
    float2 strideUv;    // from one tap to the next: (s / W, 0) or (0, s / H)
    int2 strideTexels;  // the same in texels: (s, 0) or (0, s)
};

// sat_filter.ps, sat_blur_verbatim.ps: reading it.
struct SATFilterConstants
{
    int2 extentTexels;
    float2 sizeTexels;  // full width and height of the box
    float4 bias;        // what was taken off every texel when the table was built
};

#ifdef __cplusplus
}
#endif

#endif
