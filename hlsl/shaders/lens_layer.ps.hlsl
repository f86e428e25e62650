// lens_layer.ps: what of a scene lies in one layer of depth: its light times its share in the layer, and the share.
//
// Layers lie on the axis of q = +-(c^2 - 1), where c is the circle of confusion and + stands for before the focus; q is 0 all
// over what is sharp. What lies between two knots is shared out to both, and two blurs mixed by the squares of their widths
// have the variance of the one in between.
//
// Beyond the papers
#include "boxcar/compat.hlsli"
#include "boxcar/footprint.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { LensLayerConstants g; };
Texture2D<float4> nearest : register(t0);  // light; disparity in alpha
Texture2D<float4> hidden : register(t1);   // what is seen when that is taken away

float SignedSquare(float disparity)
{
    float c = FootprintLens(disparity, g.focusDisparity, g.apertureTexels);
    return disparity > g.focusDisparity ? c * c - 1.0 : 1.0 - c * c;
}

// Reached: 0 up to a, 1 from b on: the share of a surface at q = a .. b in the layer at b, and all before it.
float Reached(float a, float b, float q)
{
    return saturate((q - a) / (b - a));
}

float4 main(QuadVertex i) : SV_Target0
{
    int3 at = int3(TexelFromEdge(i.position.xy), 0);
    float4 a = nearest.Load(at), b = hidden.Load(at);
    float qa = SignedSquare(a.a), qb = SignedSquare(b.a);
    float shareA = Reached(g.behindKnot, g.knot, qa) - Reached(g.knot, g.beforeKnot, qa);

    // What is hidden must not mix with what hides it: it is moved back as far as a layer behind that.
    float shareB = min(Reached(g.behindKnot, g.knot, qb), Reached(g.beforeKnot, g.secondBeforeKnot, qa))
                 - min(Reached(g.knot, g.beforeKnot, qb), Reached(g.secondBeforeKnot, g.thirdBeforeKnot, qa));
    return float4(shareA * a.rgb + shareB * b.rgb, shareA + shareB);
}
