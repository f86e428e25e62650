// glossy.ps: an object that reflects its surroundings, blurred by a lobe of any width. LOBE is BOX, STACK, ORDER2 or ORDER3;
// FINE, for the orders: with tables of what rounding left over.
// Hensley 2005, sect. 5.1 (Figs 5 to 7)
#include "boxcar/dual_paraboloid_sat.hlsli"
#include "constants/effect_constants.h"
#include "shaders/reflection.hlsli"

#define BOX 1
#define STACK 4
#define ORDER2 5
#define ORDER3 6

BOXCAR_CONSTANTS(Constants) { GlossyConstants g; };
Texture2D<uint4> frontLow : register(t0);
Texture2D<uint4> frontHigh : register(t1);
Texture2D<uint4> backLow : register(t2);
Texture2D<uint4> backHigh : register(t3);
#ifdef FINE
Texture2D<uint4> fineFrontLow : register(t5);
Texture2D<uint4> fineFrontHigh : register(t6);
Texture2D<uint4> fineBackLow : register(t7);
Texture2D<uint4> fineBackHigh : register(t8);
#endif

float4 LightOfOrder(DPTables tables, int order, float3 dir, float widthTexels)
{
#ifdef FINE
    DPTables fine = DPFineTablesOf(tables, fineFrontLow, fineFrontHigh, fineBackLow, fineBackHigh);
    return DPSampleSATOrderFine(tables, fine, order, dir, widthTexels);
#else
    return DPSampleSATOrder(tables, order, dir, widthTexels);
#endif
}

float4 main(SceneVertex i) : SV_Target0
{
    DPTables tables = DPTablesOf(frontLow, frontHigh, backLow, backHigh, g.largestTexels, g.codeScale);
    float3 dir = ReflectedDirection(i, g.scene.eyeWorld);
    // The Gaussian that a box of the width stands for; the other lobes are of the same sigma.
    float widthTexels = ReflectionWidth(i, g.widthTexels);
    float sigmaTexels = widthTexels / kDPBoxOverSigma;
#if LOBE == BOX
    float4 light = DPSampleSAT(tables, dir, widthTexels);
#elif LOBE == STACK
    float4 light = DPSampleSATStack(tables, dir, sigmaTexels, 4);
#elif LOBE == ORDER2
    float4 light = LightOfOrder(tables, 2, dir, kDPTentOverSigma * sigmaTexels);
#else
    float4 light = LightOfOrder(tables, 3, dir, kDPParabolicOverSigma * sigmaTexels);
#endif
    return float4(light.rgb * g.scene.albedo, 1.0);
}
