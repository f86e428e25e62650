// texture_sampled.ps: a texture as a sampler filters it: the nearest texel, four, or those of mip levels.
// Crow 1984 (Figs 3 to 7: what the table is compared with)
#include "shaders/textured.hlsli"

Texture2D<float4> pattern : register(t0);
SamplerState SAMPLER : register(s0);

float4 main(SceneVertex i) : SV_Target0
{
    return TexturedLight(i, pattern.Sample(SAMPLER, TexturedUv(i)));
}
