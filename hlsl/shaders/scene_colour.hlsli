// scene_colour.hlsli: the colour of a point of an object in the sample scenes' light.
#ifndef BOXCAR_SCENE_COLOUR_HLSLI
#define BOXCAR_SCENE_COLOUR_HLSLI

#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

// SceneColour: `checkWorld` is the side of the checks on a matt object of this albedo; 0 for none.
float3 SceneColour(SceneVertex i, float3 albedo, float checkWorld)
{
    float3 normal = normalize(i.normalWorld);
    float3 checked = SceneAlbedo(albedo, checkWorld, SceneWallPoint(i.positionWorld, normal));
    return checked * SceneLight(normal, 1.0);
}

#endif
