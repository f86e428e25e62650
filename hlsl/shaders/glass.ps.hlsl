// glass.ps: etched glass: what lies behind, blurred the more the thicker the glass is, a little displaced and tinted.
// Hensley 2005, sect. 5.3 (Fig. 8)
#include "constants/effect_constants.h"
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"
#include "shaders/table_io.hlsli"

BOXCAR_CONSTANTS(Constants) { GlassConstants g; };
Texture2D<float4> back : register(t2);  // red: distance of the far side

// Codes of 16 bits under a box of 256 x 256 texels fit into 32 bits.
static const float kWidestTexels = WORDS == 2 ? 32768.0 : 256.0;

float4 main(SceneVertex i) : SV_Target0
{
    SATExactTable words = TableRead(false);  // of the picture so far
    int2 extentTexels;
    table.GetDimensions(extentTexels.x, extentTexels.y);
    float3 ray = i.positionWorld - g.scene.eyeWorld;
    float distanceWorld = length(ray);
    float3 normal = normalize(i.normalWorld);
    float thicknessWorld = max(back.Load(int3(TexelFromEdge(i.position.xy), 0)).r - distanceWorld, 0.0);

    // Screen x and y of the normal, without a view matrix: how the position on the screen moves along it.
    float4 moved = mul(g.scene.clipFromWorld, float4(i.positionWorld + 0.01 * normal, 1.0));
    float4 here = mul(g.scene.clipFromWorld, float4(i.positionWorld, 1.0));
    float2 slope = 50.0 * (moved.xy / moved.w - here.xy / here.w) * float2(1.0, -1.0);
    float2 centre = i.position.xy - slope * g.bendTexels * thicknessWorld;
    centre = clamp(centre, 0.5, float2(extentTexels) - 0.5);

    float widthTexels = clamp(g.blurTexels * thicknessWorld / distanceWorld, 1.0, kWidestTexels);
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_CLIP);
    SATBox box = SATClipBox(frame, SATBoxAt(centre, float2(widthTexels, widthTexels)));
    float3 behind = SATSumBox(words, frame, box).rgb / (SATBoxArea(box) * g.codeScale);

    float3 tint = exp(-thicknessWorld * (1.0 - g.scene.albedo));
    float3 halfway = normalize(kSunWorld - ray / distanceWorld);
    float shine = pow(saturate(dot(normal, halfway)), 60.0);
    float grazing = pow(1.0 - saturate(-dot(normal, ray) / distanceWorld), 4.0);
    return float4(behind * tint * (1.0 - 0.5 * grazing) + 0.25 * grazing * kSkyLight + 0.5 * shine * kSunLight, 1.0);
}
