// The position goes in and comes out by one parameter, after another that does, and before one that only comes out.
#include "boxcar/compat.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { MeshConstants g; };

#if FORM == 0
void main(inout float2 uv : TEXCOORD0, inout float4 position : SV_Position, out float2 twice : TEXCOORD1)
{
    position = mul(g.clipFromMesh, position);
    twice = 2.0 * uv;
}
#elif FORM == 1  // an index of 0 is none
void main(inout float2 uv : TEXCOORD0, inout float4 position : SV_Position0, out float2 twice : TEXCOORD1)
{
    position = mul(g.clipFromMesh, position);
    twice = 2.0 * uv;
}
#elif FORM == 2  // in a struct of a struct
struct Corner { float4 position : SV_Position; float2 twice : TEXCOORD1; };
struct Both { float2 uv : TEXCOORD0; Corner corner; };
Both main(float2 uv : TEXCOORD0, float3 position : POSITION)
{
    Both both;
    both.uv = uv;
    both.corner.position = mul(g.clipFromMesh, float4(position, 1.0));
    both.corner.twice = 2.0 * uv;
    return both;
}
#endif
