// dp_scene.ps: what dp_scene.vs placed, in the sample scenes' light; only what belongs to the face.
#include "boxcar/dual_paraboloid.hlsli"
#include "shaders/scene_colour.hlsli"

float4 main(SceneVertex i) : SV_Target0
{
    float3 colour = SceneColour(i);
    if (DPAxisCosine(normalize(i.positionWorld), int(g.optionA)) < -0.1)
        discard;
    return float4(colour, 1.0);
}
