// shadow_moments.ps: depth from 0 to 1 as a code of 16 bits, and its square: what an exact table sums.
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"
#include "shaders/words_io.hlsli"

Texture2D<float4> depth : register(t0);

WordsTarget main(QuadVertex i)
{
    uint code = uint(floor(65535.0 * saturate(depth.Load(int3(TexelFromEdge(i.position.xy), 0)).r) + 0.5));
    return WordsTargetOf(SATWideOf(uint4(code, code * code, 0u, 0u), uint4(0u, 0u, 0u, 0u)));
}
