// glossy_papers.ps: the same as the papers print it: tables of floats, one width in texels all over the faces.
// Hensley 2005, sect. 5.1.1; Scheuermann 2005 (texDP_SAT)
#include "boxcar/dual_paraboloid_sat.hlsli"
#include "shaders/reflection.hlsli"

Texture2D<float4> frontTable : register(t0);
Texture2D<float4> backTable : register(t1);

float4 main(SceneVertex i) : SV_Target0
{
    int2 extentTexels;
    frontTable.GetDimensions(extentTexels.x, extentTexels.y);
    float4 light = DPSampleSATFixed(frontTable, backTable, extentTexels, ReflectedDirection(i), ReflectionWidth(i));
    return float4(light.rgb * g.albedo, 1.0);
}
