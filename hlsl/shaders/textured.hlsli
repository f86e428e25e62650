// textured.hlsli: things with nothing but a repeated texture and light on them.
#ifndef BOXCAR_TEXTURED_HLSLI
#define BOXCAR_TEXTURED_HLSLI

#include "constants/effect_constants.h"
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

BOXCAR_CONSTANTS(Constants) { TexturedConstants g; };

// TexturedUv: the texture coordinate.
float2 TexturedUv(SceneVertex i)
{
    return i.uv * g.repeats;
}

// TexturedLight: the picture's texel for a texture's value. Alpha: the light that white would give off, in green.
float4 TexturedLight(SceneVertex i, float4 value)
{
    float3 light = SceneLight(normalize(i.normalWorld), 1.0);
    return float4(light * value.rgb, light.g);
}

#endif
