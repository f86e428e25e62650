// Constants of shaders that only tests run: one text for HLSL and C++.
#ifndef BOXCAR_TEST_CONSTANTS_H
#define BOXCAR_TEST_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// subtract.ps
struct SubtractConstants {
    float4 value;
};

// sat_sample_box.ps, sat_order.ps
struct SampleConstants {
    int2 extentTexels;
    float2 sizeTexels;
    float2 offsetTexels;  // of the kernel's centre from the texel's
};

// bspline_3d.ps
struct VolumeConstants {
    float3 offsetTexels;  // of the point from the voxel's centre
    float unused;
    float3 voxelSides;
};

// textured_plane.ps
struct PlaneConstants {
    float2 acrossUv;  // from one pixel to the next
    float2 downUv;
    float2 startUv;  // at the upper left corner of the screen
    int2 extentTexels;
};

// bspline_fetch.ps
struct FetchConstants {
    int2 extentTexels;
    float2 startTexels;  // edge coordinates of the first pixel's point
    float2 stepTexels;   // from one pixel to the next
    int lookupTexels;    // width of the lookup textures
    int degree;
    float sigmaTexels;  // of the Gaussian
};

// bspline_mip.ps
struct MipConstants {
    float2 acrossUv;  // from one pixel to the next
    float2 downUv;
    float2 startUv;  // at the upper left corner of the screen
    int2 extentTexels;
    int baseLevel;  // of the line of meta texels
    int level;      // for ONE_LEVEL
};

// dp_sample.ps
struct DPSampleConstants {
    float widthTexels;  // sigma for STACK
    float codeScale;
    int largestTexels;
    int boxes;
};

// mesh.vs, mesh.ps
struct MeshConstants {
    float4x4 clipFromMesh;
    float4 value;  // .x
};

#ifdef __cplusplus
}
#endif

#endif
