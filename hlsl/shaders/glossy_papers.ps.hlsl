// glossy_papers.ps: the same as the papers print it: tables of floats, one width in texels all over the faces.
// Hensley 2005, sect. 5.1.1; Scheuermann 2005 (texDP_SAT)
#include "boxcar/dual_paraboloid_sat.hlsli"
#include "constants/effect_constants.h"
#include "shaders/reflection.hlsli"

BOXCAR_CONSTANTS(Constants) { GlossyConstants g; };
Texture2D<float4> frontTable : register(t0);
Texture2D<float4> backTable : register(t1);

float4 main(SceneVertex i) : SV_Target0
{
    int2 extentTexels;
    frontTable.GetDimensions(extentTexels.x, extentTexels.y);
    float3 dir = ReflectedDirection(i, g.scene.eyeWorld);
    float4 light = DPSampleSATFixed(frontTable, backTable, extentTexels, dir, ReflectionWidth(i, g.widthTexels));
    return float4(light.rgb * g.scene.albedo, 1.0);
}
