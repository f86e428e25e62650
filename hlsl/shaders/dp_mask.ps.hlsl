// dp_mask.ps: a face as the papers sum it: colour and 1 inside of the disc, 0 outside.
// Hensley 2005, sect. 5.1.1
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> face : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    float4 texel = face.Load(int3(TexelFromEdge(i.position.xy), 0));
    return length(2.0 * i.uv - 1.0) <= 1.0 ? float4(texel.rgb, 1.0) : (float4)0;
}
