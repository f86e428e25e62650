// sat_blur_verbatim.ps: the papers' box lookup exactly as printed, round every texel, to compare with sat_filter.ps.
// Scheuermann 2005 (tex2D_SAT_blur)
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATFilterConstants g; };
Texture2D<float4> table : register(t0);
SamplerState nearestBorder : register(s0);

#include "boxcar/d3d9.hlsli"

float4 main(QuadVertex i) : SV_Target0
{
    sampler tSAT = D3D9Sampler(table, nearestBorder);
    return tex2D_SAT_blur(tSAT, i.uv, TexelEdgeToUv(g.minTexels, g.extentTexels));
}
