// glass_back.ps: how far the far side of a glass object is from the eye.
#include "shaders/scene_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SceneConstants g; };

float4 main(SceneVertex i) : SV_Target0
{
    return float4(length(i.positionWorld - g.eyeWorld), 0.0, 0.0, 0.0);
}
