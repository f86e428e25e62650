// shadow_depth.ps: how far a surface is from a light at g.eyeWorld: 0 at g.optionA, 1 g.optionB farther.
#include "shaders/scene_io.hlsli"

float4 main(SceneVertex i) : SV_Target0
{
    float depth = saturate((length(i.positionWorld - g.eyeWorld) - g.optionA) / g.optionB);
    return float4(depth, 0.0, 0.0, 1.0);
}
