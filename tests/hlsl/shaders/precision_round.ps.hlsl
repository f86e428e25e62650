// A number rounded in three ways: .x half, .y 24 bits to the nearest, .z 24 bits truncated.
#include "boxcar/texel.hlsli"
#include "shaders/precision_round.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> source : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    float4 value = source.Load(int3(TexelFromEdge(i.position.xy), 0)).x;
    return float4(Round16(value).x, Round24(value).x, Truncate24(value).x, 0.0);
}
