// scene_colour.hlsli: the colour of a point of an object in the sample scenes' light.
#ifndef BOXCAR_SCENE_COLOUR_HLSLI
#define BOXCAR_SCENE_COLOUR_HLSLI

#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

float3 SceneColour(SceneVertex i)
{
    float3 normal = normalize(i.normalWorld);
    float3 albedo = SceneAlbedo(g.albedo, g.checkWorld, SceneWallPoint(i.positionWorld, normal));
    return albedo * SceneLight(normal, 1.0);
}

#endif
