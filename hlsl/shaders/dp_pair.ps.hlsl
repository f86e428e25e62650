// dp_pair.ps: two faces side by side, each within its disc.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> left : register(t0);
Texture2D<float4> right : register(t1);
SamplerState linearClamp : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
    float2 stepUv = float2(ddx(i.uv.x), ddy(i.uv.y));
    float2 extentTexels = 1.0 / stepUv;
    float sideTexels = min(0.5 * extentTexels.x, extentTexels.y);
    float2 cellUv = float2(frac(2.0 * i.uv.x), i.uv.y);
    float2 fromMiddle = (cellUv - 0.5) * float2(0.5 * extentTexels.x, extentTexels.y);
    float2 uv = fromMiddle / (0.97 * sideTexels) + 0.5;
    float inside = saturate(0.5 + (0.5 - length(uv - 0.5)) * 0.97 * sideTexels);
    float4 onLeft = left.SampleLevel(linearClamp, uv, 0.0), onRight = right.SampleLevel(linearClamp, uv, 0.0);
    return float4(lerp(float3(0.01, 0.01, 0.012), i.uv.x < 0.5 ? onLeft.rgb : onRight.rgb, inside), 1.0);
}
