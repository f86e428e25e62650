// FootprintCone of rays that come from a picture: red the ray's length, green the eye's distance, blue the cone.
#include "boxcar/footprint.hlsli"
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> rays : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    float4 ray = rays.Load(int3(TexelFromEdge(i.position.xy), 0));
    return float4(FootprintCone(ray.x, ray.y, ray.z), 0.0, 0.0, 0.0);
}
