// SATSampleBox and SATSampleBoxZero by uv, the box's centre moved off the texel's by an offset in texels (here `bias.xy`).
#include "boxcar/compat.hlsli"
#include "boxcar/sat.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATFilterConstants g; };
Texture2D<float4> table : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    float2 uv = TexelEdgeToUv(i.position.xy + g.bias.xy, g.extentTexels);
#if EDGE_ZERO
    return SATSampleBoxZero(table, g.extentTexels, uv, g.sizeTexels);
#else
    return SATSampleBox(table, g.extentTexels, uv, g.sizeTexels);
#endif
}
