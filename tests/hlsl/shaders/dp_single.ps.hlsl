// One sample of two faces, or the papers' lookup of their tables (FIXED is its width in texels; 0: one sample), in
// directions that come from a picture of them.
#include "boxcar/dual_paraboloid_sat.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> front : register(t0);
Texture2D<float4> back : register(t1);
Texture2D<float4> directions : register(t2);
SamplerState linearClamp : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
    float3 dir = directions.Load(int3(TexelFromEdge(i.position.xy), 0)).xyz;
    int2 extentTexels;
    front.GetDimensions(extentTexels.x, extentTexels.y);
#if FIXED
    return DPSampleSATFixed(front, back, extentTexels, dir, FIXED);
#else
    return DPSample(front, back, linearClamp, dir);
#endif
}
