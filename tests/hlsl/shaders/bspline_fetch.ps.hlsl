// A picture under a third-order filter at points a step apart, by fetches, with the kernel from arithmetic or from a lookup
// texture; and the kernels themselves at t = startTexels.x + stepTexels.x * pixel. FORM says which.
#include "boxcar/bspline_kernels.hlsli"
#include "boxcar/bspline_lookup.hlsli"
#include "boxcar/compat.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

#define ARITHMETIC 0
#define LINE 1
#define LINE_DX 2
#define LINE_DXX 3
#define DXX 4
#define DXY 5
#define DYY 6
#define DEGREE 7
#define GAUSS 8
#define LOAD 9
#define LOOKUP 10
#define LOOKUP_LINE 11
#define LOOKUP_DX 12
#define LOOKUP_DY 13
#define LOOKUP_PLAIN 14
#define LOOKUP_REPEAT 15
#define LOOKUP_NEAREST 16
#define LISTING_DX 17
#define DEGREE_WEIGHTS 18
#define HG 19
#define HG1 20

BOXCAR_CONSTANTS(Constants) { FetchConstants g; };
Texture2D<float4> source : register(t0);
Texture2D<float4> hg : register(t1);
Texture2D<float4> hg1 : register(t2);
SamplerState linearClamp : register(s0);
SamplerState linearRepeat : register(s1);
SamplerState nearestClamp : register(s2);

float4 main(QuadVertex i) : SV_Target0
{
    float2 edgeTexels = g.startTexels + g.stepTexels * (i.position.xy - 0.5);
    float2 uv = TexelEdgeToUv(edgeTexels, g.extentTexels);
    float2 t = BSplinePointOf(edgeTexels).t;
    float4 dx = (float4)0, dy = (float4)0, dxx = (float4)0, dxy = (float4)0, dyy = (float4)0;
#if FORM == ARITHMETIC
    return BSplineFetch2D(source, linearClamp, g.extentTexels, edgeTexels, BSplineHG(t.x), BSplineHG(t.y), 0.0);
#elif FORM == LINE
    return BSplineSample1D(source, linearClamp, g.extentTexels, uv);
#elif FORM == LINE_DX
    return BSplineFirst1D(source, linearClamp, g.extentTexels, uv);
#elif FORM == LINE_DXX
    return BSplineSecond1D(source, linearClamp, g.extentTexels, uv);
#elif FORM == DXX || FORM == DXY || FORM == DYY
    BSplineHessian2D(source, linearClamp, g.extentTexels, uv, dxx, dxy, dyy);
    return FORM == DXX ? dxx : FORM == DXY ? dxy : dyy;
#elif FORM == DEGREE
    return BSplineFetch2D(source, linearClamp, g.extentTexels, edgeTexels, BSplineHGOfDegree(g.degree, t.x),
                          BSplineHGOfDegree(g.degree, t.y), 0.0);
#elif FORM == GAUSS
    return BSplineFetch2D(source, linearClamp, g.extentTexels, edgeTexels,
                          BSplineHGOf(GaussianWeights(t.x, g.sigmaTexels), t.x),
                          BSplineHGOf(GaussianWeights(t.y, g.sigmaTexels), t.y), 0.0);
#elif FORM == LOAD
    return BSplineLoad2D(source, g.extentTexels, edgeTexels);
#elif FORM == LOOKUP
    return BSplineSampleLookup2D(source, hg, linearClamp, g.extentTexels, g.lookupTexels, uv);
#elif FORM == LOOKUP_LINE
    return BSplineSampleLookup1D(source, hg, linearClamp, g.extentTexels, g.lookupTexels, uv);
#elif FORM == LOOKUP_DX || FORM == LOOKUP_DY
    BSplineGradientLookup2D(source, hg, hg1, linearClamp, g.extentTexels, g.lookupTexels, uv, dx, dy);
    return FORM == LOOKUP_DX ? dx : dy;
#elif FORM == LOOKUP_PLAIN
    // Texel centres at (j + 0.5) / size: the ends are flat over half a texel.
    float3 x = hg.SampleLevel(linearClamp, float2(t.x, 0.5), 0.0).xyz;
    float3 y = hg.SampleLevel(linearClamp, float2(t.y, 0.5), 0.0).xyz;
    return BSplineFetch2D(source, linearClamp, g.extentTexels, edgeTexels, x, y, 0.0);
#elif FORM == LOOKUP_REPEAT
    // As printed: a period a texel of the source, and no fraction taken.
    float3 x = hg.SampleLevel(linearRepeat, float2(edgeTexels.x - 0.5, 0.5), 0.0).xyz;
    float3 y = hg.SampleLevel(linearRepeat, float2(edgeTexels.y - 0.5, 0.5), 0.0).xyz;
    return BSplineFetch2D(source, linearClamp, g.extentTexels, edgeTexels, x, y, 0.0);
#elif FORM == LOOKUP_NEAREST
    float3 x = BSplineHGLookup(hg, nearestClamp, g.lookupTexels, t.x);
    float3 y = BSplineHGLookup(hg, nearestClamp, g.lookupTexels, t.y);
    return BSplineFetch2D(source, linearClamp, g.extentTexels, edgeTexels, x, y, 0.0);
#elif FORM == LISTING_DX
    // Listing 20-3 with the second fetch's share, which is what .z is in listing 20-1.
    float3 x = BSplineHGLookup(hg1, linearClamp, g.lookupTexels, t.x);
    return -BSplineSlope1D(source, linearClamp, g.extentTexels, edgeTexels, x);
#elif FORM == DEGREE_WEIGHTS
    return BSplineWeightsOfDegree(g.degree, edgeTexels.x);
#elif FORM == HG
    return float4(BSplineHG(edgeTexels.x), 0.0);
#else
    return float4(BSplineHG1(edgeTexels.x), 0.0);
#endif
}
