// scene.ps: an object in the sample scenes' light.
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

float4 main(SceneVertex i) : SV_Target0
{
    float3 albedo = SceneAlbedo(g.albedo, g.checkWorld, i.positionWorld);
    return float4(albedo * SceneLight(normalize(i.normalWorld), 1.0), 1.0);
}
