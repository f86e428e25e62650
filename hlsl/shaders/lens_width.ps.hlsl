// lens_width.ps: the circle of confusion of every texel, as a map of widths: 0 is 1 texel, 1 is the largest.
// Hensley 2005, sect. 5.4
#include "boxcar/compat.hlsli"
#include "boxcar/footprint.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { LensConstants g; };
Texture2D<float4> disparity : register(t0);  // alpha

float4 main(QuadVertex i) : SV_Target0
{
    float d = disparity.Load(int3(TexelFromEdge(i.position.xy), 0)).a;
    float diameterTexels = FootprintLens(d, g.focusDisparity, g.apertureTexels);
    float t = g.largestTexels > 1.0 ? (diameterTexels - 1.0) / (g.largestTexels - 1.0) : 0.0;
    return float4(saturate(t), 0.0, 0.0, 0.0);
}
