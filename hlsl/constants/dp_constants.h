// Constants of the dual paraboloids' shaders: one text for HLSL and C++. Order the members so that none crosses a
// 16-byte line; SharedConstants.EveryStructIsTheBlockOfAShader compares them with the compiled shaders.
#ifndef BOXCAR_DP_CONSTANTS_H
#define BOXCAR_DP_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// dp_directions.ps, dp_from_cube.ps, dp_encode.ps: a face of a dual paraboloid.
struct DPFaceConstants
{
    int face;            // DP_FRONT or DP_BACK
    int sideTexels;
    float codeScale;     // color codes of light 1 and weight code 1
    float largestLight;  // brighter light becomes this
};

#ifdef __cplusplus
}
#endif

#endif
