// SATSumTexels of a list of boxes: a texel holds (lo.x, lo.y, hi.x, hi.y), as two's complement.
#include "boxcar/compat.hlsli"
#include "shaders/quad_io.hlsli"
#include "shaders/table_io.hlsli"
#include "shaders/words_io.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { SampleConstants g; };
Texture2D<uint4> boxes : register(t2);

WordsTarget main(QuadVertex i)
{
    SATExactTable words = TableRead(false);
    int4 box = int4(boxes.Load(int3(TexelFromEdge(i.position.xy), 0)));
    return WordsTargetOf(SATSumTexels(words, SATFrameAtCorner(g.extentTexels, EDGE), box.xy, box.zw));
}
