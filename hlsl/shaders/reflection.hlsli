// reflection.hlsli: what the reflecting objects have in common.
#ifndef BOXCAR_REFLECTION_HLSLI
#define BOXCAR_REFLECTION_HLSLI

#include "shaders/scene_io.hlsli"

Texture2D<float4> gloss : register(t4);  // red: share of the width
SamplerState linearRepeat : register(s0);

// Width in texels of a face at a point; g.optionA is the largest. The gloss texture lies over the object from the front.
float ReflectionWidth(SceneVertex i)
{
    float share = gloss.SampleLevel(linearRepeat, i.positionWorld.xy, 0.0).r;
    return lerp(1.0, g.optionA, share);
}

float3 ReflectedDirection(SceneVertex i)
{
    return reflect(normalize(i.positionWorld - g.eyeWorld), normalize(i.normalWorld));
}

#endif
