// planar_reflected.ps: an object seen in the plane y = 0, with its height over it in alpha.
// Hensley 2005, sect. 5.2
#include "shaders/scene_colour.hlsli"

BOXCAR_CONSTANTS(Constants) { MattConstants g; };

float4 main(SceneVertex i) : SV_Target0
{
    return float4(SceneColour(i, g.scene.albedo, g.checkWorld), i.positionWorld.y);
}
