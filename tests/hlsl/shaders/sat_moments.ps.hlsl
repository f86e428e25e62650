// SATMomentsOf of a list of boxes: a texel holds (lo.x, lo.y, hi.x, hi.y). Mean, variance, and the share that
// can be sizeTexels.x or more.
#include "boxcar/compat.hlsli"
#include "boxcar/sat_moments.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { SampleConstants g; };
Texture2D<uint4> table : register(t0);
Texture2D<uint4> tableHigh : register(t1);
Texture2D<float4> boxes : register(t2);

float4 main(QuadVertex i) : SV_Target0
{
    float4 edges = boxes.Load(int3(TexelFromEdge(i.position.xy), 0));
    SATBox box;
    box.loTexels = edges.xy;
    box.hiTexels = edges.zw;
    SATFrame frame = SATFrameAtCorner(g.extentTexels, SAT_EDGE_CLIP);
    SATMoments m = SATMomentsOf(SATTable64(table, tableHigh, false), frame, SATClipBox(frame, box));
    return float4(m.mean, m.variance, SATUpperShare(m, g.sizeTexels.x), 1.0);
}
