// scene_io.hlsli: what scene.vs hands to the pixel shaders.
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

// A direction of the mesh, turned about +y as the object is.
float3 Turned(SceneConstants scene, float3 v)
{
    return float3(scene.turnCosine * v.x + scene.turnSine * v.z, v.y,
                  scene.turnCosine * v.z - scene.turnSine * v.x);
}

#endif
