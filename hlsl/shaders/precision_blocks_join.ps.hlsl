// precision_blocks_join.ps: the whole table, every entry read from its block.
// Crow 1984, sect. 3
#include "boxcar/texel.hlsli"
#include "shaders/precision_blocks.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<uint4> local : register(t0);
Texture2D<uint4> left : register(t1);
Texture2D<uint4> top : register(t2);

uint4 main(QuadVertex i) : SV_Target0
{
    return BlocksLoad(local, left, top, TexelFromEdge(i.position.xy));
}
