// sat_bias.ps: takes a bias off every texel, before the table is built. A pass of its own, because a build pass must
// count what lies outside the image as 0, not as 0 - bias.
// Hensley 2005, sect. 4.2.1
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> source : register(t0);
Texture2D<float4> bias : register(t1);  // one texel

float4 main(QuadVertex i) : SV_Target0
{
    return source.Load(int3(TexelFromEdge(i.position.xy), 0)) - bias.Load(int3(0, 0, 0));
}
