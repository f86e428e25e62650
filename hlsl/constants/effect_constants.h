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

// soft_shadow.ps
struct SoftShadowConstants {
    float4x4 clipFromWorld;  // of the lamp
    float3 lampWorld;
    float nearWorld;  // from the lamp to where its map's depth is 0
    float reachWorld;  // and from there to 1
    float lampSizeWorld;
    float texelsAtOne;  // of the map, in one unit of width one unit away from the lamp
    float bleedCut;     // shares of light below become 0
    float3 skyLight;
    float unused;
};

// lens_layer.ps: one layer of depth. Its knot, and those of the layer behind it and of the three before it, are
// signed squares of circles of confusion.
struct LensLayerConstants {
    float focusDisparity;
    float apertureTexels;
    float behindKnot;
    float knot;
    float beforeKnot;
    float secondBeforeKnot;
    float thirdBeforeKnot;
};

// lens_over.ps: that layer, blurred, behind those in front of it.
struct LensOverConstants {
    float diameterTexels;  // odd
    int boxes;             // that stand for a disc
    int sides;             // of a polygon instead of it; 0 for a disc
    float codeScale;       // what 1 is in codes
    float opacity;         // times its coverage: over 1 it closes gaps
    int isLast;            // 1: nothing comes behind it
};

// lens_mips.ps
struct LensMipsConstants {
    float focusDisparity;
    float apertureTexels;
    float noiseLevels;  // how far the level is moved at random, up or down, and the place by as much of its texels
};

// lens_views.ps
struct LensViewsConstants {
    float share;  // of a view in the sum
};

#ifdef __cplusplus
}
#endif

#endif
