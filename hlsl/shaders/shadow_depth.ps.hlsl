// shadow_depth.ps: how far a surface is from a lamp, from 0 to 1.
#include "constants/effect_constants.h"
#include "shaders/scene_io.hlsli"

BOXCAR_CONSTANTS(Constants) { ShadowDepthConstants g; };

float4 main(SceneVertex i) : SV_Target0
{
    float depth = saturate((length(i.positionWorld - g.scene.eyeWorld) - g.nearWorld) / g.reachWorld);
    return float4(depth, 0.0, 0.0, 1.0);
}
