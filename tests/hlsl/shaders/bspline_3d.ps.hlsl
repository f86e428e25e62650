// A volume under the cubic B-spline, at a point off each voxel's centre; slices lie one below the other. FORM says which
// function.
#include "boxcar/bspline_lookup.hlsli"
#include "boxcar/compat.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

#define SAMPLE 0
#define LOAD 1
#define GRADIENT 2
#define LOAD_GRADIENT 3
#define LOAD_PURE 4
#define LOAD_MIXED 5
#define CURVATURE 6
#define LOOKUP 7

BOXCAR_CONSTANTS(Constants) { VolumeConstants g; };
Texture3D<float> source : register(t0);
Texture2D<float4> hg : register(t1);
SamplerState linearClamp : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
    int3 extentTexels;
    source.GetDimensions(extentTexels.x, extentTexels.y, extentTexels.z);
    float slice = floor(i.position.y / float(extentTexels.y));
    float3 edgeTexels = float3(i.position.x, i.position.y - slice * float(extentTexels.y), slice + 0.5) + g.offsetTexels;
    float3 uvw = edgeTexels / float3(extentTexels);
#if FORM == SAMPLE
    return float4(BSplineSample3D(source, linearClamp, extentTexels, uvw), 0.0, 0.0, 1.0);
#elif FORM == LOAD
    return float4(BSplineLoad3D(source, extentTexels, edgeTexels), 0.0, 0.0, 1.0);
#elif FORM == LOOKUP
    int2 lookupTexels;
    hg.GetDimensions(lookupTexels.x, lookupTexels.y);
    return float4(BSplineSampleLookup3D(source, hg, linearClamp, extentTexels, lookupTexels.x, uvw), 0.0, 0.0, 1.0);
#elif FORM == GRADIENT
    return float4(BSplineGradient3D(source, linearClamp, extentTexels, uvw), 1.0);
#else
    BSplineDerivatives3D d = BSplineHessian3D(source, extentTexels, edgeTexels);
#if FORM == CURVATURE
    d = BSplineScaled(d, g.voxelSides);
    return float4(BSplineCurvature(d.gradient, d.pure, d.mixed), d.value, 1.0);
#else
    return float4(FORM == LOAD_GRADIENT ? d.gradient : FORM == LOAD_PURE ? d.pure : d.mixed, d.value);
#endif
#endif
}
