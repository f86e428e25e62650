// dp_scene.ps: what dp_scene.vs placed, in the sample scenes' light; only what belongs to the face.
#include "boxcar/dual_paraboloid.hlsli"
#include "constants/effect_constants.h"
#include "shaders/scene_colour.hlsli"

BOXCAR_CONSTANTS(Constants) { DPSceneConstants g; };

float4 main(SceneVertex i) : SV_Target0
{
    float3 colour = SceneColour(i, g.scene.albedo, g.checkWorld);
    if (DPAxisCosine(normalize(i.positionWorld), g.face) < -0.1)
        discard;
    return float4(colour, 1.0);
}
