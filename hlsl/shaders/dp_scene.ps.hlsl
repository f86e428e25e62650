// dp_scene.ps: what dp_scene.vs placed, in the sample scenes' light; only what belongs to the face.
#include "boxcar/dual_paraboloid.hlsli"
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

float4 main(SceneVertex i) : SV_Target0
{
    float3 normal = normalize(i.normalWorld);
    float3 albedo = SceneAlbedo(g.albedo, g.checkWorld, SceneWallPoint(i.positionWorld, normal));
    if (DPAxisCosine(normalize(i.positionWorld), int(g.optionA)) < -0.1)
        discard;
    return float4(albedo * SceneLight(normal, 1.0), 1.0);
}
