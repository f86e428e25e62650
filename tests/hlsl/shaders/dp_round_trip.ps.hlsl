// Where a face's direction lies on it again, and what of it is not of length 1.
#include "boxcar/dual_paraboloid.hlsli"
#include "shaders/quad_io.hlsli"

float4 main(QuadVertex i) : SV_Target0
{
    float3 dir = DPUvToDirection(i.uv, FACE);
    return float4(DPDirectionToUv(dir, FACE), length(dir), 0.0);
}
