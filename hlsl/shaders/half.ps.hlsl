// half.ps: an image half as large: a level of a mip map. Odd sides lose a little of their last texel.
#include "boxcar/compat.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> source : register(t0);
SamplerState linearClamp : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
    return source.SampleLevel(linearClamp, i.uv, 0.0);  // between four texels: their mean
}
