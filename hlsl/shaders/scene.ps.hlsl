// scene.ps: an object in the sample scenes' light.
#include "shaders/scene_colour.hlsli"

float4 main(SceneVertex i) : SV_Target0
{
    return float4(SceneColour(i), 1.0);
}
