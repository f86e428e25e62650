// bspline_lookup.ps: the lookup texture of a kernel: x and y how far off the two fetches lie, z the second one's share.
#include "boxcar/bspline_kernels.hlsli"
#include "boxcar/compat.hlsli"
#include "constants/bspline_constants.h"
#include "shaders/quad_io.hlsli"

#define VALUE 0
#define FIRST 1
#define GAUSS 2
#define GAUSS_FIRST 3

BOXCAR_CONSTANTS(Constants) { BSplineLookupConstants g; };

float4 main(QuadVertex i) : SV_Target0
{
    // The end points lie on the first and the last texel's centre.
    float t = (i.position.x - 0.5) / (g.sizeTexels - 1);
#if KERNEL == VALUE
    float3 hg = BSplineHG(t);
#elif KERNEL == FIRST
    float3 hg = BSplineHG1(t);
#elif KERNEL == GAUSS
    float3 hg = BSplineHGOf(GaussianWeights(t, g.sigmaTexels), t);
#else
    float3 hg = BSplineHGOf(GaussianWeights1(t, g.sigmaTexels), t);
#endif
    return float4(hg, 1.0);
}
