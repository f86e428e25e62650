// precision_blocks.hlsli: Crow's blocks: a table of 8-bit codes in 16-bit entries.
//
// The image is cut into blocks of 16 x 16 texels. 256 codes of 8 bits sum to at most 65,280, so a table of the block
// alone fits 16 bits. Crow adds one 32-bit value a block, the sum at its corner; but an entry of the whole table also
// holds what lies straight left of the block and straight above it, which changes from row to row and from column to
// column. What makes it right is a value a row and one a column of each block:
//
//   local  W x H            16 bits: the sum inside the block, left of and above the texel, itself included
//   left   W / 16 x H       32 bits: the whole table at the last column before the block, T(16 X - 1, y)
//   top    W x H / 16       32 bits: what the columns of the block up to x hold above it,
//                           T(x, 16 Y - 1) - T(16 X - 1, 16 Y - 1)
//
//   T(x, y) = local(x, y) + left(X, y) + top(x, Y)
//
// Storage: 16 + 32 / 16 + 32 / 16 = 20 bits a texel and channel, against 32, and 16.125 as Crow counts them.
//
// Crow 1984, sect. 3
#ifndef BOXCAR_PRECISION_BLOCKS_HLSLI
#define BOXCAR_PRECISION_BLOCKS_HLSLI

static const int kBlockTexels = 16;

// BlocksCorner: the table at a texel, 0 left of and above the image.
uint4 BlocksCorner(Texture2D<uint4> table, int2 texel)
{
    uint4 value = table.Load(int3(max(texel, 0), 0));
    return (texel.x >= 0 && texel.y >= 0) ? value : (uint4)0;
}

// BlocksSplitLocal, BlocksSplitLeft, BlocksSplitTop: a table's parts. `texel` is the part's own.
uint4 BlocksSplitLeft(Texture2D<uint4> table, int2 texel)
{
    return BlocksCorner(table, int2(kBlockTexels * texel.x - 1, texel.y));
}

uint4 BlocksSplitTop(Texture2D<uint4> table, int2 texel)
{
    int block = int(uint(texel.x) / uint(kBlockTexels));
    int row = kBlockTexels * texel.y - 1;
    return BlocksCorner(table, int2(texel.x, row)) - BlocksCorner(table, int2(kBlockTexels * block - 1, row));
}

uint4 BlocksSplitLocal(Texture2D<uint4> table, int2 texel)
{
    int2 block = int2(uint2(texel) / uint(kBlockTexels));
    uint4 sum = BlocksCorner(table, texel) - BlocksSplitLeft(table, int2(block.x, texel.y)) -
                BlocksSplitTop(table, int2(texel.x, block.y));
    return sum & 0xffffu;  // all that a 16-bit entry keeps
}

// BlocksLoad: an entry of the whole table.
uint4 BlocksLoad(Texture2D<uint4> local, Texture2D<uint4> left, Texture2D<uint4> top, int2 texel)
{
    int2 block = int2(uint2(texel) / uint(kBlockTexels));
    return local.Load(int3(texel, 0)) + left.Load(int3(block.x, texel.y, 0)) + top.Load(int3(texel.x, block.y, 0));
}

#endif
