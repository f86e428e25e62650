// isosurface.hlsli: blocks of a volume, and where they lie in their image.
//
// Slices of blocks lie side by side, in rows of `blocksAcross`.
#ifndef BOXCAR_ISOSURFACE_HLSLI
#define BOXCAR_ISOSURFACE_HLSLI

#include "constants/isosurface_constants.h"

static const int kBlockCells = ISOSURFACE_BLOCK_CELLS;

int3 IsosurfaceBlocks(int3 extentVoxels)
{
    return (extentVoxels + kBlockCells - 1) / kBlockCells;
}

// The block that a point is in; points before the first voxel's centre belong to the first cell.
int3 IsosurfaceBlockOf(float3 edgeVoxels)
{
    return int3(max(floor(edgeVoxels - 0.5), 0.0)) / kBlockCells;
}

int2 IsosurfaceBlockTexel(int3 block, int3 blocks, int blocksAcross)
{
    uint across = uint(blocksAcross);
    uint column = uint(block.z) % across, row = uint(block.z) / across;
    return int2(column, row) * blocks.xy + block.xy;
}

#endif
