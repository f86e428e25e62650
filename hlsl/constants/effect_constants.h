// Constants of the effects' shaders: one text for HLSL and C++. Order the members so that none crosses a 16-byte
// line.
#ifndef BOXCAR_EFFECT_CONSTANTS_H
#define BOXCAR_EFFECT_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
#include "hlsl/constants/scene_constants.h"
namespace boxcar {
#else
#include "constants/scene_constants.h"
#endif

// glossy.ps, glossy_papers.ps
struct GlossyConstants {
    SceneConstants scene;
    float widthTexels;  // of a face: the lobe's, where the gloss texture is 1
    float codeScale;    // what 1 is in the tables' codes
    int largestTexels;  // width of the widest box that the tables hold
};

// phong.ps. The scene's albedo is the matt color.
struct PhongConstants {
    SceneConstants scene;
    float exponent;   // of the highlight's lobe
    float shine;      // the highlight's share of the light
    int boxes;        // in each of the two stacks
    float codeScale;  // what 1 is in the tables' codes
};

// dp_scene.vs, dp_scene.ps
struct DPSceneConstants {
    SceneConstants scene;
    float checkWorld;  // side of the object's checks; 0 for none
    int face;          // DP_FRONT or DP_BACK
    float farWorld;    // the distance that is depth 1
};

// planar_floor.ps
struct PlanarFloorConstants {
    SceneConstants scene;
    float checkWorld;   // side of the floor's checks; 0 for none
    float coneTexels;   // width of a ray's cone that is as wide as the ray is long
    float codeScale;    // what 1 is in the table's codes
    float mirrorShare;  // of the reflection at a right angle
};

// glass.ps. Both lengths are for one unit of glass, one unit away from the eye.
struct GlassConstants {
    SceneConstants scene;
    float blurTexels;  // width of the blur
    float bendTexels;  // how far the picture is displaced
    float codeScale;   // what 1 is in the table's codes
};

#define TEXTURE_SIDE_TEXELS 256
#define TEXTURE_WHITE_CODES 255  // what 1 is in the codes of the texture's table

// texture_sampled.ps, texture_bspline.ps, texture_table.ps
struct TexturedConstants {
    SceneConstants scene;
    float2 repeats;  // of the texture, along the mesh's u and v
};

// shadow_depth.ps. The scene's eye is the lamp.
struct ShadowDepthConstants {
    SceneConstants scene;
    float nearWorld;   // from the lamp to where depth is 0
    float reachWorld;  // and from there to 1
};

// lens_scene.ps
struct LensSceneConstants {
    SceneConstants scene;
    float brightness;  // of the first material
};

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
