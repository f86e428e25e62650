// sat_encode.ps: light as the whole numbers that an exact table sums.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"
#include "shaders/words_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATEncodeConstants g; };
Texture2D<float4> source : register(t0);

WordsTarget main(QuadVertex i)
{
    float4 value = source.Load(int3(TexelFromEdge(i.position.xy), 0));
    return WordsTargetOf(SATWideFromFloat(clamp(value * g.scale, 0.0, g.largest)));
}
