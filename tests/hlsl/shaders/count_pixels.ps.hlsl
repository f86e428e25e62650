// Draws the first number of one buffer, and counts in another how many pixels there are.
#include "shaders/quad_io.hlsli"

StructuredBuffer<uint> shown : register(t0);
RWStructuredBuffer<uint> counts : register(u1);

float4 main(QuadVertex i) : SV_Target0
{
    InterlockedAdd(counts[0], 1u);
    return float4(shown[0], i.uv, 1.0);
}
