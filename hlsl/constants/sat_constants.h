// Constants of the summed-area table's shaders: one text for HLSL and C++. Order the members so that none crosses a
// 16-byte line; SharedConstants.EveryStructIsTheBlockOfAShader compares them with the compiled shaders.
#ifndef BOXCAR_SAT_CONSTANTS_H
#define BOXCAR_SAT_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// sat_pass.vs, sat_pass_load.ps, sat_pass_exact.ps: one pass of building the table.
struct SATPassConstants
{
    float2 strideUv;    // from one tap to the next: (s / W, 0) or (0, s / H)
    int2 strideTexels;  // the same in texels: (s, 0) or (0, s)
    int2 originTexels;  // the corner that the sums start from; (0, 0) for sat_pass.vs
};

// mean.ps: one level of the mean's mip chain.
struct MeanConstants
{
    int2 extentTexels;  // of the level that is read
    float divisor;      // 1, and the number of texels of the picture for the last level
};

// sat_encode.ps: light as whole numbers.
struct SATEncodeConstants
{
    float scale;    // what 1 is in codes
    float largest;  // code; brighter light becomes this
};

// sat_extend.ps: a picture with what surrounds it.
struct SATExtendConstants
{
    int2 extentTexels;   // of the picture
    int2 paddingTexels;  // on the left and on top
    int isMirrored;      // 1: the picture and its mirror image by turns; 0: the picture over and over
};

// sat_filter.ps, sat_filter_exact.ps, sat_blur_verbatim.ps: reading it.
struct SATFilterConstants
{
    int2 extentTexels;    // of the table
    int2 originTexels;    // the corner that its sums start from
    int2 paddingTexels;   // the table's texel that the result's texel (0, 0) is
    int2 widthMapTexels;  // extent of the map of widths; (1, 1) for one width everywhere
    float2 minTexels;     // width and height of the box where the map is 0
    float2 maxTexels;     // and where it is 1
    int boxes;            // that stand for a disc or a polygon; 1 for a box
    int sides;            // of the polygon; 0 for a disc
    int isSigned;         // 1: codes may be negative
    float codeScale;      // what 1 is in codes: 255, 65535, 2^24
    float largestMass;    // of SATBoxIsExact
    int isWholeX;         // 1: orders 2 and 3 are whole on x, or on y (SATSumOrder)
    int isWholeY;
};

#ifdef __cplusplus
}
#endif

#endif
