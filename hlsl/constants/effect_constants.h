// Constants of the effects' shaders: one text for HLSL and C++. Order the members so that none crosses a 16-byte
// line.
#ifndef BOXCAR_EFFECT_CONSTANTS_H
#define BOXCAR_EFFECT_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// lens_width.ps
struct LensConstants {
    float focusDisparity;
    float apertureTexels;  // diameter of the circle of confusion for a disparity that differs by 1
    float largestTexels;   // the width that the map's 1 stands for
};

// texture_pattern.ps
struct TexturePatternConstants {
    float2 cells;  // black and white ones along the texture's sides
};

#ifdef __cplusplus
}
#endif

#endif
