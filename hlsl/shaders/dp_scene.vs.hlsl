// dp_scene.vs: places a mesh straight on a face of a dual paraboloid seen from the origin. Lines should become curves;
// the rasteriser draws them straight, so only small triangles come out right.
// Scheuermann 2005 (direct rendering); Hensley 2005, sect. 5.1.1
#include "boxcar/dual_paraboloid.hlsli"
#include "constants/effect_constants.h"
#include "shaders/scene_io.hlsli"

BOXCAR_CONSTANTS(Constants) { DPSceneConstants g; };

SceneVertex main(float3 position : POSITION, float3 normal : NORMAL, float2 uv : TEXCOORD0)
{
    SceneVertex o;
    o.positionWorld = g.scene.offsetWorld + g.scene.scale * Turned(g.scene, position);
    float distanceWorld = length(o.positionWorld);
    float3 dir = o.positionWorld / max(distanceWorld, 1e-6);
    // The axis of the other face has no place here: triangles round it are left to the other face.
    float denominator = max(1.0 + DPAxisCosine(dir, g.face), 1e-2);
    o.position = float4(dir.xy / denominator, saturate(distanceWorld / g.farWorld), 1.0);
    o.normalWorld = Turned(g.scene, normal);
    o.uv = uv;
    return o;
}
