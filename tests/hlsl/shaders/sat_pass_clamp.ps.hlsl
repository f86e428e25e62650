// One pass with two taps and a sampler that clamps to the edge: the papers' other boundary set-up, which wants a black
// frame round the image.
#include "boxcar/compat.hlsli"
#include "boxcar/sat_build.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATPassConstants g; };
Texture2D<float4> source : register(t0);
SamplerState nearestClamp : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
    return SATPass2(source, nearestClamp, float4(i.uv, (i.uv - g.strideUv).yx));
}
