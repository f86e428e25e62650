// environment.ps: what lies behind a scene.
#include "boxcar/compat.hlsli"
#include "constants/scene_constants.h"
#include "shaders/equirectangular.hlsli"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { BackdropConstants g; };
Texture2D<float4> environment : register(t0);
SamplerState linearRepeat : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
    float2 p = float2(2.0 * i.uv.x - 1.0, 1.0 - 2.0 * i.uv.y);
    float3 dir = normalize(g.forwardWorld + p.x * g.rightWorld + p.y * g.upWorld);
    return float4(EquirectangularSample(environment, linearRepeat, dir), 1.0);
}
