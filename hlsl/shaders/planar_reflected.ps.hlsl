// planar_reflected.ps: an object seen in the plane y = 0, with its height over it in alpha.
// Hensley 2005, sect. 5.2
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

float4 main(SceneVertex i) : SV_Target0
{
    float3 albedo = SceneAlbedo(g.albedo, g.checkWorld, i.positionWorld);
    return float4(albedo * SceneLight(normalize(i.normalWorld), 1.0), i.positionWorld.y);
}
