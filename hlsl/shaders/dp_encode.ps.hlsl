// dp_encode.ps: a face as the whole numbers that an exact table sums: light times weight in rgb, the weight in alpha, as
// one and the same code in both, so that a constant stays constant.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/dp_constants.h"
#include "shaders/quad_io.hlsli"
#define WORDS 2
#include "shaders/words_io.hlsli"

BOXCAR_CONSTANTS(Constants) { DPFaceConstants g; };
Texture2D<float4> face : register(t0);

WordsTarget main(QuadVertex i)
{
    float4 texel = face.Load(int3(TexelFromEdge(i.position.xy), 0));
    float weight = floor(4096.0 * texel.a + 0.5);
    float3 light = clamp(texel.rgb, 0.0, g.largestLight);
    return WordsTargetOf(SATWideFromFloat(float4(light * (weight * g.codeScale), weight)));
}
