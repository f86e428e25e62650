// One sample at the texel's uv, moved by `strideUv`, through the sampler named on the command line.
#include "boxcar/compat.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATPassConstants g; };
Texture2D<float4> source : register(t0);
SamplerState SAMPLER : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
    return source.Sample(SAMPLER, i.uv + g.strideUv);
}
