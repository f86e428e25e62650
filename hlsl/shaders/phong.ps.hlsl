// phong.ps: the Phong model under light from all around: a wide stack of boxes round the normal, a narrow one round the
// reflection.
// Hensley 2005, sect. 5.1.2 (Fig. 7)
#include "boxcar/dual_paraboloid_sat.hlsli"
#include "constants/effect_constants.h"
#include "shaders/reflection.hlsli"

BOXCAR_CONSTANTS(Constants) { PhongConstants g; };
Texture2D<uint4> frontLow : register(t0);
Texture2D<uint4> frontHigh : register(t1);
Texture2D<uint4> backLow : register(t2);
Texture2D<uint4> backHigh : register(t3);

float4 main(SceneVertex i) : SV_Target0
{
    DPTables tables = DPTablesOf(frontLow, frontHigh, backLow, backHigh, 1, g.codeScale);
    float halfTexels = 0.5 * tables.sideTexels;
    float3 matt = DPSampleSATStack(tables, normalize(i.normalWorld), BoxStackSigma(1.0) * halfTexels, g.boxes).rgb;
    float3 dir = ReflectedDirection(i, g.scene.eyeWorld);
    float3 shine = DPSampleSATStack(tables, dir, BoxStackSigma(g.exponent) * halfTexels, g.boxes).rgb;
    return float4(lerp(matt * g.scene.albedo, shine, g.shine), 1.0);
}
