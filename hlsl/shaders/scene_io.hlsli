// scene_io.hlsli: what scene.vs hands to the pixel shaders, and the constants of both.
#ifndef BOXCAR_SCENE_IO_HLSLI
#define BOXCAR_SCENE_IO_HLSLI

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

// A direction of the mesh, turned about +y as the object is.
float3 Turned(float3 v)
{
    return float3(g.turn.x * v.x + g.turn.y * v.z, v.y, g.turn.x * v.z - g.turn.y * v.x);
}

#endif
