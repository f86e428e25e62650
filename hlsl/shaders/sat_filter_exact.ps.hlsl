// sat_filter_exact.ps: the mean over a box, a disc, a tent or a parabolic kernel round every texel, from a table of
// integers. ORDER is 1, 2 or 3; WHOLE is 1 where SATSumWhole does it (one whole width everywhere). Texels whose sum may
// not fit into the words become NaN.
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
    float4 sum;
    float mass;
#if WHOLE
    int2 whole = int2(sizeTexels);
    sum = SATWideToFloat(SATSumWhole(words, g.extentTexels, ORDER, texel, whole), words.words, words.isSigned);
    mass = EDGE != SAT_EDGE_CLIP ? SATMassFull(ORDER, sizeTexels.x) * SATMassFull(ORDER, sizeTexels.y)
         : SATMassWhole(ORDER, texel.x, whole.x, g.extentTexels.x)
         * SATMassWhole(ORDER, texel.y, whole.y, g.extentTexels.y);
#elif ORDER == 1
    sum = (float4)0;
    mass = 0.0;
    int boxes = BoxesFor(sizeTexels);
    for (int k = 0; k < boxes; k++)
    {
        SATBox box = SATDiscBox(TexelCentre(texel), sizeTexels, boxes > 1 ? g.sides : 0, boxes, k);
        SATBox inside = SATClipBox(frame, box);
        sum += SATSumBox(words, frame, inside);
        mass += EDGE == SAT_EDGE_ZERO ? SATBoxArea(box) : SATBoxArea(inside);
    }
#else
    sum = SATSumOrder(words, g.extentTexels, ORDER, TexelCentre(texel), sizeTexels);
    mass = EDGE != SAT_EDGE_CLIP ? SATMassFull(ORDER, sizeTexels.x) * SATMassFull(ORDER, sizeTexels.y)
         : SATMassOrder(ORDER, texel.x + 0.5, sizeTexels.x, g.extentTexels.x)
         * SATMassOrder(ORDER, texel.y + 0.5, sizeTexels.y, g.extentTexels.y);
#endif
    return SATBoxIsExact(sizeTexels, ORDER, WHOLE != 0, g.largestMass) ? sum / (mass * g.codeScale) : asfloat(0x7fc00000u).xxxx;
}
