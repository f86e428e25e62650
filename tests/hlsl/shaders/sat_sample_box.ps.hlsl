// SATSampleBox, SATSampleBoxZero and SATSampleBoxRepeat by uv, the box's centre moved off the texel's.
#include "boxcar/compat.hlsli"
#include "boxcar/sat.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { SampleConstants g; };
Texture2D<float4> table : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    float2 uv = TexelEdgeToUv(i.position.xy + g.offsetTexels, g.extentTexels);
    return SAMPLE(table, g.extentTexels, uv, g.sizeTexels);
}
