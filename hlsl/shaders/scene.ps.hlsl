// scene.ps: an object in the sample scenes' light.
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

float4 main(SceneVertex i) : SV_Target0
{
    float3 normal = normalize(i.normalWorld);
    float3 albedo = SceneAlbedo(g.albedo, g.checkWorld, SceneWallPoint(i.positionWorld, normal));
    return float4(albedo * SceneLight(normal, 1.0), 1.0);
}
