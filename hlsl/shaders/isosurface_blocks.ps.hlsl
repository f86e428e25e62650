// isosurface_blocks.ps: the largest voxel that a tricubic lookup in a block can reach; a trilinear one reaches fewer.
#include "boxcar/compat.hlsli"
#include "constants/isosurface_constants.h"
#include "shaders/isosurface.hlsli"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { IsosurfaceBlocksConstants g; };
Texture3D<float> volume : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    int3 extent;
    volume.GetDimensions(extent.x, extent.y, extent.z);
    int3 blocks = IsosurfaceBlocks(extent);
    int2 texel = int2(i.position.xy);
    int2 tile = texel / blocks.xy;
    int3 block = int3(texel - tile * blocks.xy, tile.y * g.blocksAcross + tile.x);
    int3 first = kBlockCells * block - 1;
    float largest = volume.Load(int4(min(kBlockCells * block, extent - 1), 0));
    for (int z = 0; z < kBlockCells + 3; z++)
        for (int y = 0; y < kBlockCells + 3; y++)
            for (int x = 0; x < kBlockCells + 3; x++)
                largest = max(largest, volume.Load(int4(clamp(first + int3(x, y, z), 0, extent - 1), 0)));
    return float4(largest, 0.0, 0.0, 1.0);
}
