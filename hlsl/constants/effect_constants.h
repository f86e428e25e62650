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
