// lens_scene.ps: a scene of many materials, with the disparity (1 / depth) of what is seen in alpha. HIDDEN is 1 for what
// comes into sight when the nearest surface is taken away.
#include "boxcar/texel.hlsli"
#include "constants/effect_constants.h"
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

BOXCAR_CONSTANTS(Constants) { LensSceneConstants g; };
Texture2D<float4> palette : register(t0);  // a texel a material: its albedo, and in alpha the side of its checks
#if HIDDEN
Texture2D<float4> nearest : register(t1);  // the picture of the nearest surface
#endif

// i.uv.x: the number of the material.
float4 main(SceneVertex i) : SV_Target0
{
    float disparity = 1.0 / mul(g.scene.clipFromWorld, float4(i.positionWorld, 1.0)).w;
    int material = int(i.uv.x + 0.5);
    float4 surface = palette.Load(int3(material, 0, 0));
    float3 albedo = SceneAlbedo(surface.rgb, surface.a, i.positionWorld);
#if HIDDEN
    if (disparity > 0.99 * nearest.Load(int3(TexelFromEdge(i.position.xy), 0)).a)
        discard;
#endif
    return float4((material == 0 ? g.brightness : 1.0) * albedo * SceneLight(normalize(i.normalWorld), 1.0), disparity);
}
