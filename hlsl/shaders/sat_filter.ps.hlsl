// sat_filter.ps: the mean over a box or a disc round every texel, from a table of floats. EDGE is a SAT_EDGE_...
// Crow 1984, sect. 2.1; Hensley 2005, sect. 4.2.1 (the bias, added back over the area that carried it)
#include "boxcar/sat.hlsli"
#include "shaders/sat_filter_io.hlsli"

Texture2D<float4> table : register(t0);
Texture2D<float4> bias : register(t1);  // one texel: what was taken off when the table was built

float4 main(QuadVertex i) : SV_Target0
{
    SATFrame frame;
    frame.extentTexels = g.extentTexels;
    frame.originTexels = g.originTexels;
    frame.edge = EDGE;

    float2 sizeTexels = SizeAt(TexelFromEdge(i.position.xy));
    float4 sum = (float4)0;
    float insideTexels = 0.0, wholeTexels = 0.0;
    int boxes = BoxesFor(sizeTexels);
    for (int k = 0; k < boxes; k++)
    {
        SATBox whole = SATDiscBox(i.position.xy, sizeTexels, boxes > 1 ? g.sides : 0, boxes, k);
        SATBox inside = SATClipBox(frame, whole);
        sum += SATSumBox(table, frame, inside);
        insideTexels += SATBoxArea(inside);
        wholeTexels += SATBoxArea(whole);
    }
    float4 biasTexel = bias.Load(int3(0, 0, 0));
    return EDGE == SAT_EDGE_ZERO ? (sum + insideTexels * biasTexel) / wholeTexels : sum / insideTexels + biasTexel;
}
