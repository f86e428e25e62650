// bspline_sample.hlsli: pictures under the cubic B-spline, by few linear fetches or with exact weights.
//
//   BSplineSample2D      4 linear fetches: needs a format that is filtered with more than 8 bits of weight
//   BSplineLoad2D        16 loads, weights of floats
//   CatmullRomSample2D   9 linear fetches
//   CatmullRomLoad2D     16 loads
//
// The B-spline smooths: it goes through texels only after a prefilter (runtime/passes/bspline_prefilter.h).
//
// Sigg 2005, sect. 20.2
#ifndef BOXCAR_BSPLINE_SAMPLE_HLSLI
#define BOXCAR_BSPLINE_SAMPLE_HLSLI

#include "boxcar/bspline.hlsli"
#include "boxcar/texel.hlsli"

// Where a point lies among texel centres.
struct BSplinePoint
{
    int2 first;  // texel i
    float2 t;    // 0 to 1, from there to i + 1
};

BSplinePoint BSplinePointOf(float2 edgeTexels)
{
    float2 x = edgeTexels - 0.5;
    BSplinePoint p;
    p.first = int2(floor(x));
    p.t = x - floor(x);
    return p;
}

// BSplineSample2D: the cubic B-spline of a picture.
//
//   source       any number of texels
//   linearClamp  linear filter; what lies outside is the sampler's: clamp goes on with the edge texel
//   uv           [0, 1] across the picture
//
// Error: in float formats 7e-6 of the range at 256 texels, growing with the size: uv holds the place in 24 bits; with 8-bit
//        weights of the sampler 6e-3 (BSpline.FewFetchesAreNearTheSpline).
// Cost:  4 linear fetches.
//
// Sigg 2005, listing 20-2
float4 BSplineSample2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    BSplinePoint p = BSplinePointOf(edgeTexels);
    float3 x = BSplineHG(p.t.x), y = BSplineHG(p.t.y);
    float2 lo = TexelEdgeToUv(edgeTexels - float2(x.x, y.x), extentTexels);
    float2 hi = TexelEdgeToUv(edgeTexels + float2(x.y, y.y), extentTexels);
    float4 top = lerp(source.SampleLevel(linearClamp, lo, 0.0), source.SampleLevel(linearClamp, float2(hi.x, lo.y), 0.0), x.z);
    float4 bottom = lerp(source.SampleLevel(linearClamp, float2(lo.x, hi.y), 0.0), source.SampleLevel(linearClamp, hi, 0.0), x.z);
    return lerp(top, bottom, y.z);
}

// BSplineSum2D: the sum of 4 x 4 texels times weights; the edge texel goes on outside.
//
// Cost: 16 loads.
float4 BSplineSum2D(Texture2D<float4> source, int2 extentTexels, int2 first, float4 weightsX, float4 weightsY)
{
    float4 sum = (float4)0;
    [unroll]
    for (int y = 0; y < 4; y++)
    {
        float4 row = (float4)0;
        [unroll]
        for (int x = 0; x < 4; x++)
            row += weightsX[x] * source.Load(int3(clamp(first + int2(x, y) - 1, 0, extentTexels - 1), 0));
        sum += weightsY[y] * row;
    }
    return sum;
}

// BSplineLoad2D: the same spline with weights of floats, for formats that samplers filter with 8 bits.
//
//   edgeTexels  the point, in edge coordinates
//
// Error: 3 u of the largest texel (BSpline.ExactWeightsAreTheSpline).
// Cost:  16 loads.
float4 BSplineLoad2D(Texture2D<float4> source, int2 extentTexels, float2 edgeTexels)
{
    BSplinePoint p = BSplinePointOf(edgeTexels);
    return BSplineSum2D(source, extentTexels, p.first, BSplineWeights(p.t.x), BSplineWeights(p.t.y));
}

// CatmullRomLoad2D: the cubic that goes through the texels.
//
// Error: 4 u of the largest texel. It overshoots by up to a quarter of a step.
// Cost:  16 loads.
float4 CatmullRomLoad2D(Texture2D<float4> source, int2 extentTexels, float2 edgeTexels)
{
    BSplinePoint p = BSplinePointOf(edgeTexels);
    return BSplineSum2D(source, extentTexels, p.first, CatmullRomWeights(p.t.x), CatmullRomWeights(p.t.y));
}

// CatmullRomSample2D: the same by linear fetches: the middle pair of each axis is one.
//
// Cost: 9 linear fetches.
float4 CatmullRomSample2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv)
{
    BSplinePoint p = BSplinePointOf(TexelUvToEdge(uv, extentTexels));
    float4 wx = CatmullRomWeights(p.t.x), wy = CatmullRomWeights(p.t.y);
    float3 shareX = float3(wx.x, wx.y + wx.z, wx.w), shareY = float3(wy.x, wy.y + wy.z, wy.w);
    float2 middle = float2(wx.z / shareX.y, wy.z / shareY.y);
    float4 sum = (float4)0;
    [unroll]
    for (int y = 0; y < 3; y++)
    {
        [unroll]
        for (int x = 0; x < 3; x++)
        {
            float2 offset = float2(x == 1 ? middle.x : x == 0 ? -1.0 : 2.0, y == 1 ? middle.y : y == 0 ? -1.0 : 2.0);
            float2 at = TexelEdgeToUv(TexelCentre(p.first) + offset, extentTexels);
            sum += shareX[x] * shareY[y] * source.SampleLevel(linearClamp, at, 0.0);
        }
    }
    return sum;
}

#endif
