// lens_layer.ps: what of a scene lies in one layer of depth: its light times its share in the layer, and the share.
//
// Layers are hats over q = +-(c^2 - 1), where c is the circle of confusion and + stands for before the focus. What lies
// between two knots is shared out to both, and two blurs mixed by the squares of their widths have the variance of the one
// in between. q is 0 all over what is sharp.
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

float ShareOf(float q)
{
    return saturate(min((q - g.behindKnot) / (g.knot - g.behindKnot), (g.beforeKnot - q) / (g.beforeKnot - g.knot)));
}

float4 main(QuadVertex i) : SV_Target0
{
    int3 at = int3(TexelFromEdge(i.position.xy), 0);
    float4 surface = nearest.Load(at);
    float q = SignedSquare(surface.a);
    float share = ShareOf(q);
    if (q >= g.beforeKnot)
    {
        // What is hidden must not mix with what hides it: the first layer that has none of the latter takes all of it.
        bool isFirst = q < g.secondBeforeKnot;
        surface = hidden.Load(at);
        q = SignedSquare(surface.a);
        share = ShareOf(isFirst ? min(q, g.knot) : q);
    }
    return float4(share * surface.rgb, share);
}
