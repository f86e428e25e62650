// scene_io.hlsli: what scene.vs hands to the pixel shaders, and the constants of both.
#include "boxcar/compat.hlsli"
#include "constants/scene_constants.h"

struct SceneVertex
{
    float4 position : SV_Position;
    float3 positionWorld : TEXCOORD0;
    float3 normalWorld : TEXCOORD1;
    float2 uv : TEXCOORD2;
};

BOXCAR_CONSTANTS(Constants) { SceneConstants g; };
