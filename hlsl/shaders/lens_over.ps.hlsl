// lens_over.ps: blurs a layer of depth, its coverage too, and puts it behind what is in front of it.
//
// That leaves 1 - alpha uncovered. The layer takes what it covers of it, as long as anything is left: layers of one surface,
// whose shares add up to 1, have no gap between them. Coverage divides the light, so that a surface goes on a little where
// it is not known.
//
// Beyond the papers
#include "boxcar/compat.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"
#include "shaders/table_io.hlsli"

BOXCAR_CONSTANTS(Constants) { LensOverConstants g; };
Texture2D<float4> before : register(t2);  // light times coverage; coverage in alpha

// NearestEdge: the whole edge nearest to a point; boxes that share an edge find the same.
int2 NearestEdge(float2 edgeTexels)
{
    return int2(floor(edgeTexels + 0.501));
}

float4 main(QuadVertex i) : SV_Target0
{
    SATExactTable words = TableRead(false);  // of the layer
    int2 extentTexels;
    before.GetDimensions(extentTexels.x, extentTexels.y);
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
    float share = min(g.opacity * coverage, 1.0 - light.a);
    if (share > 0.0)
        light += share * float4(sum.rgb / sum.a, 1.0);
    return g.isLast != 0 ? float4(light.rgb / light.a, 1.0) : light;
}
