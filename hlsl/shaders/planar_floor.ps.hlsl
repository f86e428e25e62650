// planar_floor.ps: a glossy floor: matt checks under a reflection that is blurred by how far its rays went.
// Hensley 2005, sect. 5.2 (Fig. 1)
#include "boxcar/footprint.hlsli"
#include "constants/effect_constants.h"
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"
#include "shaders/table_io.hlsli"

BOXCAR_CONSTANTS(Constants) { PlanarFloorConstants g; };
Texture2D<float4> reflected : register(t2);  // alpha: height over the floor

float4 main(SceneVertex i) : SV_Target0
{
    SATExactTable words = TableRead(false);
    int2 extentTexels;
    reflected.GetDimensions(extentTexels.x, extentTexels.y);
    float3 toEye = g.scene.eyeWorld - i.positionWorld;
    float eyeDistance = length(toEye);
    float heightWorld = reflected.Load(int3(TexelFromEdge(i.position.xy), 0)).a;
    float rayDistance = heightWorld * eyeDistance / toEye.y;

    float widthTexels = FootprintCone(rayDistance, eyeDistance, g.coneTexels);
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_CLIP);
    SATBox box = SATClipBox(frame, SATBoxAt(i.position.xy, float2(widthTexels, widthTexels)));
    float3 mirror = SATSumBox(words, frame, box).rgb / (SATBoxArea(box) * g.codeScale);

    float grazing = 1.0 - toEye.y / eyeDistance;
    float share = lerp(g.mirrorShare, 1.0, grazing * grazing * grazing * grazing * grazing);  // Schlick
    float3 matt = SceneAlbedo(g.scene.albedo, g.checkWorld, i.positionWorld) * SceneLight(float3(0.0, 1.0, 0.0), 1.0);
    return float4(lerp(matt, mirror, share), 1.0);
}
