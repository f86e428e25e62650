// lens_layer.ps: what of a scene lies in one layer of depth, times its share in it, and the share in alpha.
//
// Layers are hats over q = +-(c^2 - 1), where c is the circle of confusion and + stands for before the focus. What lies
// between two knots is shared out to both, and two blurs mixed by the squares of their widths have the variance of the one
// in between. q is 0 all over what is sharp.
//
// Beyond the papers; hidden surfaces kept apart from the nearest one as in Mara et al. 2016
#include "boxcar/compat.hlsli"
#include "boxcar/footprint.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { LensLayerConstants g; };
Texture2D<float4> nearest : register(t0);  // light; disparity in alpha
Texture2D<float4> hidden : register(t1);   // what is behind it

float ShareAt(float disparity)
{
    float c = FootprintLens(disparity, g.focusDisparity, g.apertureTexels);
    float q = disparity > g.focusDisparity ? c * c - 1.0 : 1.0 - c * c;
    return saturate(min((q - g.behindKnot) / (g.knot - g.behindKnot), (g.beforeKnot - q) / (g.beforeKnot - g.knot)));
}

float4 main(QuadVertex i) : SV_Target0
{
    int3 at = int3(TexelFromEdge(i.position.xy), 0);
    float4 surface = nearest.Load(at);
    float share = ShareAt(surface.a);
    if (share == 0.0)
    {
        surface = hidden.Load(at);
        share = ShareAt(surface.a);
    }
    return float4(share * surface.rgb, share);
}
