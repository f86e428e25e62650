// precision_blocks_split.ps: one of the three parts of a table in blocks; PART = Local, Left or Top.
// Crow 1984, sect. 3
#include "boxcar/texel.hlsli"
#include "shaders/precision_blocks.hlsli"
#include "shaders/quad_io.hlsli"

#define Local 0
#define Left 1
#define Top 2

Texture2D<uint4> table : register(t0);

uint4 main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy);
#if PART == Local
    return BlocksSplitLocal(table, texel);
#elif PART == Left
    return BlocksSplitLeft(table, texel);
#else
    return BlocksSplitTop(table, texel);
#endif
}
