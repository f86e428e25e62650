// sat_filter_exact.ps: the mean over a box, a disc, a tent or a parabolic kernel round every texel, from a table of
// integers, rounded once. ORDER is 1, 2 or 3; WHOLE is 1 where SATSumWhole does it (one whole width everywhere). Texels
// whose sum may not fit into the words become NaN.
// Hensley 2005, sect. 2 and 4; exactness: beyond the papers
#include "boxcar/sat_order.hlsli"
#include "shaders/sat_filter_io.hlsli"
#include "shaders/table_io.hlsli"

float4 main(QuadVertex i) : SV_Target0
{
    SATExactTable words = TableRead(g.isSigned != 0);
    SATFrame frame = SATFrameAtCorner(g.extentTexels, EDGE);
    int2 texel = TexelFromEdge(i.position.xy);
    float2 sizeTexels = SizeAt(texel);
    texel += g.paddingTexels;
    // Everything is counted from the texel, whose center is at 0.5.
        FloatPair sum, mass;
#if ORDER == 1 && !WHOLE
    sum = FloatPairSplat(0.0);
    mass = FloatPairSplat(0.0);
    int boxes = BoxesFor(sizeTexels);
    for (int k = 0; k < boxes; k++)
    {
        FloatPair edges = SATDiscEdges(sizeTexels, boxes > 1 ? g.sides : 0, boxes, k);
        SATCutBox cut = SATCutBoxOf(frame, texel, FloatPairAdd(FloatPairSplat(0.5), edges));
        sum = FloatPairAdd(sum, SATSumCutBox(words, frame, cut));
        FloatPair area = SATEdgesArea(edges);
        if (EDGE == SAT_EDGE_CLIP)
            area = SATCutArea(cut);
        mass = FloatPairAdd(mass, area);
    }
#else
    FloatPair massX = SATMassFull(ORDER, sizeTexels.x), massY = SATMassFull(ORDER, sizeTexels.y);
    int2 after = g.extentTexels - 1 - texel;
#if WHOLE
    int2 whole = int2(sizeTexels);
    sum = SATWideToPair(SATSumWhole(words, g.extentTexels, ORDER, texel, whole), words.words, words.isSigned);
    if (EDGE == SAT_EDGE_CLIP)
    {
        massX = SATMassWhole(ORDER, texel.x, whole.x, g.extentTexels.x);
        massY = SATMassWhole(ORDER, texel.y, whole.y, g.extentTexels.y);
    }
#else
    sum = SATSumOrder(words, g.extentTexels, ORDER, texel, float2(0.5, 0.5), sizeTexels, g.isWholeX != 0,
                      g.isWholeY != 0);
    if (EDGE == SAT_EDGE_CLIP)
    {
        massX = SATMassOrder(ORDER, sizeTexels.x, texel.x + 0.5, after.x + 0.5);
        massY = SATMassOrder(ORDER, sizeTexels.y, texel.y + 0.5, after.y + 0.5);
        if (g.isWholeX != 0)
            massX = SATMassWhole(ORDER, texel.x, int(sizeTexels.x), g.extentTexels.x);
        if (g.isWholeY != 0)
            massY = SATMassWhole(ORDER, texel.y, int(sizeTexels.y), g.extentTexels.y);
    }
#endif
    mass = FloatPairMul(massX, massY);
#endif
    bool isExact = SATBoxIsExact(sizeTexels, ORDER, WHOLE != 0, g.largestMass);
    float4 mean = FloatPairToFloat(FloatPairDiv(sum, FloatPairMul(mass, FloatPairSplat(g.codeScale))));
    return isExact ? mean : asfloat(0x7fc00000u).xxxx;
}
