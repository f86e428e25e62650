// scene.ps: an object in the sample scenes' light.
#include "shaders/scene_colour.hlsli"

BOXCAR_CONSTANTS(Constants) { MattConstants g; };

float4 main(SceneVertex i) : SV_Target0
{
    return float4(SceneColour(i, g.scene.albedo, g.checkWorld), 1.0);
}
