// bspline_fetch.hlsli: linear fetches where a kernel's `hg` says, and lines and second derivatives made of them.
//
//   BSplineFetch1D, BSplineFetch2D               2 and 4 fetches: any kernel, from arithmetic or from a lookup texture
//   BSplineSample1D, BSplineFirst1D              the cubic B-spline along x and its first derivative, 2 fetches
//   BSplineSecond1D                              its second derivative, 3 fetches
//   BSplineSecond2D                              dxx, dxy and dyy of a picture, 16 fetches
//
// Derivatives are per texel. What lies outside is the sampler's.
//
// Sigg 2005, listings 20-1 to 20-4
#ifndef BOXCAR_BSPLINE_FETCH_HLSLI
#define BOXCAR_BSPLINE_FETCH_HLSLI

#include "boxcar/bspline_sample.hlsli"

// The two fetches of a line.
struct BSplinePair
{
    float4 first;
    float4 second;
};

// BSplinePair1D: at x - hg.x and x + hg.y.
BSplinePair BSplinePair1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 hg,
                          float level)
{
    BSplinePair pair;
    float2 first = edgeTexels - float2(hg.x, 0.0), second = edgeTexels + float2(hg.y, 0.0);
    pair.first = source.SampleLevel(linearClamp, TexelEdgeToUv(first, extentTexels), level);
    pair.second = source.SampleLevel(linearClamp, TexelEdgeToUv(second, extentTexels), level);
    return pair;
}

// BSplineFetch1D: a kernel along x.
//
//   source        for a line: one texel high
//   linearClamp   linear filter
//   extentTexels  of `level`
//   edgeTexels    the point, in edge coordinates of `level`; a .y between texels mixes two lines
//   hg            the kernel at the point: BSplineHG, BSplineHGOf, BSplineHGOfDegree, BSplineHGLookup
//   level         a whole one
//
// Cost: 2 linear fetches.
float4 BSplineFetch1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 hg,
                      float level)
{
    BSplinePair pair = BSplinePair1D(source, linearClamp, extentTexels, edgeTexels, hg, level);
    return lerp(pair.first, pair.second, hg.z);
}

// BSplineFetch2D: a kernel along x times one along y; the parameters are those of BSplineFetch1D.
//
// Cost: 4 linear fetches.
//
// Sigg 2005, listing 20-2
float4 BSplineFetch2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 x,
                      float3 y, float level)
{
    float4 top = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels - float2(0.0, y.x), x, level);
    float4 bottom = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels + float2(0.0, y.y), x, level);
    return lerp(top, bottom, y.z);
}

// BSplineSample1D: the cubic B-spline along x.
//
// Error: in float formats 7e-6 of the range at 256 texels (BSplineFetch.LinesAreNearTheSpline).
// Cost:  2 linear fetches.
//
// Sigg 2005, listing 20-1
float4 BSplineSample1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels)
{
    float3 hg = BSplineHG(BSplinePointOf(edgeTexels).t.x);
    return BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels, hg, 0.0);
}

// BSplineSlope1D: the first derivative along x from a derivative's `hg`.
//
//   hg  BSplineHG1, or a lookup texture of it. Its .z is the second fetch's weight; the listing's is the first one's, which
//       is as large and of the other sign.
//
// Cost: 2 linear fetches.
//
// Sigg 2005, listing 20-3
float4 BSplineSlope1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 hg)
{
    BSplinePair pair = BSplinePair1D(source, linearClamp, extentTexels, edgeTexels, hg, 0.0);
    return hg.z * (pair.second - pair.first);
}

// BSplineFirst1D: the first derivative along x of the cubic B-spline.
//
// Error: in float formats 9e-6 of the range at 256 texels (BSplineFetch.LinesAreNearTheSpline).
// Cost:  2 linear fetches.
float4 BSplineFirst1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels)
{
    float3 hg = BSplineHG1(BSplinePointOf(edgeTexels).t.x);
    return BSplineSlope1D(source, linearClamp, extentTexels, edgeTexels, hg);
}

// BSplineSecond1D: the second derivative along x. It is piecewise linear, so fetches one texel apart are enough, and no
// weights are needed.
//
// Error: in float formats 3e-7 of the range, where uv is exact (BSplineFetch.LinesAreNearTheSpline).
// Cost:  3 linear fetches.
//
// Sigg 2005, listing 20-4
float4 BSplineSecond1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels)
{
    BSplinePair beside = BSplinePair1D(source, linearClamp, extentTexels, edgeTexels, float3(1.0, 1.0, 0.0), 0.0);
    float4 here = source.SampleLevel(linearClamp, TexelEdgeToUv(edgeTexels, extentTexels), 0.0);
    return (beside.first - here) + (beside.second - here);
}

// BSplineSecond2D: the Hessian of a picture. (1, -2, 1) of linear fetches along the axis that is derived twice, two lines or
// columns of them for the other axis; the mixed one by first derivatives along both.
//
//   dxx, dxy, dyy  per texel squared
//
// Error: in float formats 1.8e-5 of the range at 256 texels (BSplineFetch.SecondDerivativesAreNearTheSpline).
// Cost:  16 linear fetches.
//
// Sigg 2005, sect. 20.4
void BSplineSecond2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, out float4 dxx,
                     out float4 dxy, out float4 dyy)
{
    float2 t = BSplinePointOf(edgeTexels).t;
    float3 x = BSplineHG(t.x), y = BSplineHG(t.y);
    float3 x1 = BSplineHG1(t.x), y1 = BSplineHG1(t.y);

    float2 up = float2(0.0, -y.x), down = float2(0.0, y.y);
    dxx = lerp(BSplineSecond1D(source, linearClamp, extentTexels, edgeTexels + up),
               BSplineSecond1D(source, linearClamp, extentTexels, edgeTexels + down), y.z);

    float4 above = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels - float2(0.0, 1.0), x, 0.0);
    float4 here = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels, x, 0.0);
    float4 below = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels + float2(0.0, 1.0), x, 0.0);
    dyy = (above - here) + (below - here);

    up = float2(0.0, -y1.x);
    down = float2(0.0, y1.y);
    dxy = y1.z * (BSplineSlope1D(source, linearClamp, extentTexels, edgeTexels + down, x1) -
                  BSplineSlope1D(source, linearClamp, extentTexels, edgeTexels + up, x1));
}

#endif
