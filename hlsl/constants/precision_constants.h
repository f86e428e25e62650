// Constants of the precision laboratory's shaders: one text for HLSL and C++. Order the members so that none crosses a
// 16-byte line; SharedConstants.EveryStructIsTheBlockOfAShader compares them with the compiled shaders.
#ifndef BOXCAR_PRECISION_CONSTANTS_H
#define BOXCAR_PRECISION_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// precision_texel.ps: what is summed.
struct PrecisionTexelConstants
{
    float4 bias;        // taken off every texel, in the source's units
    int2 extentTexels;  // of the source
    int frameTexels;    // of black round it in the target: 0 or 1
    float scale;        // times the source: 1, or the largest code
};

// precision_line.ps, precision_merge.ps: one line, and the two targets into one.
struct PrecisionLineConstants
{
    int4 stepTexels;  // .xy: from the line before to this one, (1, 0) or (0, 1)
};

// precision_box.ps: reading a table.
struct PrecisionBoxConstants
{
    int2 extentTexels;  // of the source
    int2 middleTexels;
    float4 bias;
    int2 sizeTexels;    // of the box: odd, so that its corners are whole
    int2 frameTexels;   // .x: the frame round the table, 0 or 1
};

#ifdef __cplusplus
}
#endif

#endif
