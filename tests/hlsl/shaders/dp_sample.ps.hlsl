// Light round directions that come from a picture of them. LOBE and FINE as in glossy.ps.
#include "boxcar/compat.hlsli"
#include "boxcar/dual_paraboloid_sat.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

#define BOX 1
#define STACK 4
#define ORDER2 5
#define ORDER3 6

BOXCAR_CONSTANTS(Constants) { DPSampleConstants g; };
Texture2D<uint4> frontLow : register(t0);
Texture2D<uint4> frontHigh : register(t1);
Texture2D<uint4> backLow : register(t2);
Texture2D<uint4> backHigh : register(t3);
Texture2D<float4> directions : register(t4);
#ifdef FINE
Texture2D<uint4> fineFrontLow : register(t5);
Texture2D<uint4> fineFrontHigh : register(t6);
Texture2D<uint4> fineBackLow : register(t7);
Texture2D<uint4> fineBackHigh : register(t8);
#endif

float4 main(QuadVertex i) : SV_Target0
{
    DPTables tables = DPTablesOf(frontLow, frontHigh, backLow, backHigh, g.largestTexels, g.codeScale);
    float3 dir = directions.Load(int3(TexelFromEdge(i.position.xy), 0)).xyz;
#if LOBE == BOX
    return DPSampleSAT(tables, dir, g.widthTexels);
#elif LOBE == STACK
    return DPSampleSATStack(tables, dir, g.widthTexels, g.boxes);
#elif defined(FINE)
    DPTables fine = DPFineTablesOf(tables, fineFrontLow, fineFrontHigh, fineBackLow, fineBackHigh);
    return DPSampleSATOrderFine(tables, fine, LOBE == ORDER2 ? 2 : 3, dir, g.widthTexels);
#elif LOBE == ORDER2
    return DPSampleSATOrder(tables, 2, dir, g.widthTexels);
#else
    return DPSampleSATOrder(tables, 3, dir, g.widthTexels);
#endif
}
