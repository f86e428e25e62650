// reflection.hlsli: what the reflecting objects have in common.
#ifndef BOXCAR_REFLECTION_HLSLI
#define BOXCAR_REFLECTION_HLSLI

#include "shaders/scene_io.hlsli"

Texture2D<float4> gloss : register(t4);  // red: share of the width
SamplerState linearRepeat : register(s0);

// Width in texels of a face at a point. The gloss texture lies over the object from the front.
//
//   largestTexels  where the texture is 1
float ReflectionWidth(SceneVertex i, float largestTexels)
{
    float share = gloss.SampleLevel(linearRepeat, i.positionWorld.xy, 0.0).r;
    return lerp(1.0, largestTexels, share);
}

float3 ReflectedDirection(SceneVertex i, float3 eyeWorld)
{
    return reflect(normalize(i.positionWorld - eyeWorld), normalize(i.normalWorld));
}

#endif
