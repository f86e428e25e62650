// phong.ps: the Phong model under light from all around: a wide stack of boxes round the normal, a narrow one round the
// reflection.
// Hensley 2005, sect. 5.1.2 (Fig. 7)
#include "boxcar/dual_paraboloid_sat.hlsli"
#include "shaders/reflection.hlsli"

Texture2D<uint4> frontLow : register(t0);
Texture2D<uint4> frontHigh : register(t1);
Texture2D<uint4> backLow : register(t2);
Texture2D<uint4> backHigh : register(t3);

// g.albedo: .r the exponent of the highlight, .g its share of the light, .b boxes a stack; g.optionB: the tables' code scale.
float4 main(SceneVertex i) : SV_Target0
{
    DPTables tables = DPTablesOf(frontLow, frontHigh, backLow, backHigh, 1, g.optionB);
    float halfTexels = 0.5 * tables.sideTexels;
    int boxes = int(g.albedo.b);
    float3 matt = DPSampleSATStack(tables, normalize(i.normalWorld), BoxStackSigma(1.0) * halfTexels, boxes).rgb;
    float3 shine = DPSampleSATStack(tables, ReflectedDirection(i), BoxStackSigma(g.albedo.r) * halfTexels, boxes).rgb;
    return float4(lerp(matt * float3(0.62, 0.30, 0.20), shine, g.albedo.g), 1.0);
}
