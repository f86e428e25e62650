// dp_from_cube.ps: a face of a dual paraboloid from a cube map: light in rgb, what the texel counts in alpha. LOOKUP is 1
// where a texture holds the directions, 0 where they are computed; both give the same bits.
// Scheuermann 2005; Hensley 2005, sect. 5.1
#include "boxcar/compat.hlsli"
#include "boxcar/dual_paraboloid.hlsli"
#include "constants/dp_constants.h"
#include "shaders/quad_io.hlsli"

TextureCube<float4> cube : register(t0);
#if LOOKUP
Texture2D<float4> directions : register(t1);
#else
BOXCAR_CONSTANTS(Constants) { DPFaceConstants g; };
#endif
SamplerState linearClamp : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
#if LOOKUP
    float4 direction = directions.Load(int3(TexelFromEdge(i.position.xy), 0));
#else
    float4 direction = float4(DPUvToDirection(i.uv, g.face), DPWeight(i.uv, g.sideTexels));
#endif
    return float4(cube.SampleLevel(linearClamp, direction.xyz, 0.0).rgb, direction.w);
}
