// bspline_sample.hlsli: lines and pictures under the cubic B-spline, by few linear fetches or with exact weights.
//
//   BSplineSample1D, BSplineSample2D    2 and 4 linear fetches: needs a format that is filtered with more than 8 bits of weight
//   BSplineFetch1D, BSplineFetch2D      the same for any kernel: fetches where its `hg` says
//   BSplineLoad2D                       16 loads, weights of floats
//   CatmullRomSample2D                  9 linear fetches
//   CatmullRomLoad2D                    16 loads
//
// The B-spline smooths: it goes through texels only after a prefilter (runtime/passes/bspline_prefilter.h).
//
// Sigg 2005, listings 20-1 and 20-2
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

// BSplineFetch1D: a kernel along x.
//
//   source        for a line: one texel high
//   linearClamp   linear filter; what lies outside is the sampler's: clamp goes on with the edge texel
//   extentTexels  of `level`
//   edgeTexels    the point, in edge coordinates of `level`; a .y between texels mixes two lines
//   hg            the kernel at the point: BSplineHG, BSplineHGOf, BSplineHGOfDegree, BSplineHGLookup
//   level         a whole one
//
// Cost: 2 linear fetches.
float4 BSplineFetch1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 hg,
                      float level)
{
    float2 first = TexelEdgeToUv(edgeTexels - float2(hg.x, 0.0), extentTexels);
    float2 second = TexelEdgeToUv(edgeTexels + float2(hg.y, 0.0), extentTexels);
    return lerp(source.SampleLevel(linearClamp, first, level), source.SampleLevel(linearClamp, second, level), hg.z);
}

// BSplineFetch2D: a kernel along x times one along y; the parameters are those of BSplineFetch1D.
//
// Cost: 4 linear fetches.
float4 BSplineFetch2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 x,
                      float3 y, float level)
{
    float4 top = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels - float2(0.0, y.x), x, level);
    float4 bottom = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels + float2(0.0, y.y), x, level);
    return lerp(top, bottom, y.z);
}

// BSplineSample1D: the cubic B-spline of a line.
//
//   uv  [0, 1] across the line in .x; a .y between texels mixes two lines
//
// Error: in float formats 7e-6 of the range at 256 texels (BSplineFetch.LinesAreNearTheSpline).
// Cost:  2 linear fetches.
//
// Sigg 2005, listing 20-1
float4 BSplineSample1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    return BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels, BSplineHG(BSplinePointOf(edgeTexels).t.x), 0.0);
}

// BSplineSampleOf2D: the spline of a whole level, from its own extent.
//
// Cost: 4 linear fetches.
float4 BSplineSampleOf2D(Texture2D<float4> source, SamplerState linearClamp, int2 levelTexels, float2 uv, float level)
{
    float2 edgeTexels = TexelUvToEdge(uv, levelTexels);
    float2 t = BSplinePointOf(edgeTexels).t;
    return BSplineFetch2D(source, linearClamp, levelTexels, edgeTexels, BSplineHG(t.x), BSplineHG(t.y), level);
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
    return BSplineSampleOf2D(source, linearClamp, extentTexels, uv, 0.0);
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
// Error: 4 u of the largest texel. It goes beyond them by up to 0.28 of their range.
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
