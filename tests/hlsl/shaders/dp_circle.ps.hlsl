// The circle of a cone of directions. Directions come from a picture of them, its alpha is the radius at the pole.
#include "boxcar/dual_paraboloid.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> directions : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    float4 direction = directions.Load(int3(TexelFromEdge(i.position.xy), 0));
    DPCircle circle = DPCircleOf(direction.xyz, FACE, direction.w);
    return float4(circle.centre, circle.radius, DPIsSeen(circle) ? 1.0 : 0.0);
}
