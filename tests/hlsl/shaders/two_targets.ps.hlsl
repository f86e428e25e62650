// Two targets: the texel's address, and the sum of two sources.
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> left : register(t0);
Texture2D<float4> right : register(t1);

struct Targets
{
    float4 address : SV_Target0;
    float4 sum : SV_Target1;
};

Targets main(QuadVertex i)
{
    int2 texel = TexelFromEdge(i.position.xy);
    Targets o;
    o.address = float4(texel, i.uv);
    o.sum = left.Load(int3(texel, 0)) + right.Load(int3(texel, 0));
    return o;
}
