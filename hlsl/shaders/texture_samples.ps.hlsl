// texture_samples.ps: adds 2 x 2 samples of a pixel to those before.
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> before : register(t0);
Texture2D<float4> samples : register(t1);

float4 main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy);
    float4 sum = samples.Load(int3(2 * texel, 0)) + samples.Load(int3(2 * texel + int2(1, 0), 0))
               + samples.Load(int3(2 * texel + int2(0, 1), 0)) + samples.Load(int3(2 * texel + 1, 0));
    return before.Load(int3(texel, 0)) + sum / 256.0;
}
