// lens_over.ps: blurs a layer of depth, its shares too, and puts it behind the layers in front of it.
//
// What is in front leaves 1 - alpha uncovered. The layer fills of that as much as it covers by itself: neighbours on one
// surface, whose shares add up to 1, leave no gap between them, and what a silhouette lets through comes from behind.
// Coverage divides the light, so that where a layer goes on hidden from view it is continued by what is seen of it.
//
// Beyond the papers
#include "boxcar/compat.hlsli"
#include "boxcar/sat_exact.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { LensOverConstants g; };
Texture2D<uint4> table : register(t0);    // of the layer
Texture2D<float4> before : register(t1);  // light times coverage; coverage in alpha

// NearestEdge: the whole edge nearest to a point; boxes that share an edge find the same.
int2 NearestEdge(float2 edgeTexels)
{
    return int2(floor(edgeTexels + 0.501));
}

float4 main(QuadVertex i) : SV_Target0
{
    int2 extentTexels;
    before.GetDimensions(extentTexels.x, extentTexels.y);
    SATExactTable words = SATTable32(table);
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_CLIP);
    float4 sum = (float4)0;
    float areaTexels = 0.0;
    for (int k = 0; k < g.boxes; k++)
    {
        float2 diameterTexels = float2(g.diameterTexels, g.diameterTexels);
        SATBox box = SATClipBox(frame, SATDiscBox(i.position.xy, diameterTexels, g.sides, g.boxes, k));
        int2 lo = NearestEdge(box.loTexels), hi = NearestEdge(box.hiTexels);
        sum += SATWideToFloat(SATSumTexels(words, frame, lo, hi), words.words, words.isSigned);
        areaTexels += float((hi.x - lo.x) * (hi.y - lo.y));
    }
    float coverage = sum.a / (areaTexels * g.codeScale);

    float4 light = before.Load(int3(TexelFromEdge(i.position.xy), 0));
    if (coverage > 0.0)
        light += min(coverage, 1.0 - light.a) * float4(sum.rgb / sum.a, 1.0);
    return g.isLast != 0 ? float4(light.rgb / light.a, 1.0) : light;
}
