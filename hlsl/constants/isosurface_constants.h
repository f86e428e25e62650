// Constants of the isosurface effect's shaders: one text for HLSL and C++. Order the members so that none crosses a
// 16-byte line.
#ifndef BOXCAR_ISOSURFACE_CONSTANTS_H
#define BOXCAR_ISOSURFACE_CONSTANTS_H

#define ISOSURFACE_BLOCK_CELLS 4  // of a block's side; a cell lies between two voxels

// What isosurface_shade.ps shows.
#define ISOSURFACE_PHONG 0      // light alone
#define ISOSURFACE_CURVATURE 1  // a color for each pair of principal curvatures
#define ISOSURFACE_RIDGES 2     // ridges light, valleys dark
#define ISOSURFACE_NORMAL 3     // the normal in the world as a color
#define ISOSURFACE_MAXIMUM 4    // blue to red by the larger curvature

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// isosurface_march.ps: the ray of a pixel goes from the eye along forward + x right + y up, x and y from -1 to 1. All in
// voxels, from the volume's corner.
struct IsosurfaceMarchConstants {
    float3 eyeVoxels;
    float iso;
    float3 forwardVoxels;
    float stepVoxels;
    float3 rightVoxels;
    int blocksAcross;  // slices of blocks in a row of their image
    float3 upVoxels;
};

// isosurface_shade.ps. Along the volume's axes, but for the world's own.
struct IsosurfaceShadeConstants {
    float3 eyeMillimetres;  // from the volume's corner
    int shade;              // ISOSURFACE_PHONG, ..
    float3 voxelMillimetres;
    float radiusMillimetres;  // of a curvature that has its full colour
    float3 lightMillimetres;  // towards the lamp; of length 1
    float unused0;
    float3 worldX;  // the world's axes; of length 1
    float unused1;
    float3 worldY;
    float unused2;
    float3 worldZ;
};

// isosurface_blocks.ps
struct IsosurfaceBlocksConstants {
    int blocksAcross;
};

#ifdef __cplusplus
}
#endif

#endif
