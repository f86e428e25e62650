// bspline_gradient.hlsli: derivatives of lines and pictures under the cubic B-spline, per texel.
//
//   BSplineFirst1D, BSplineSecond1D  of a line, by 2 and 3 linear fetches
//   BSplineGradient2D                dx and dy, by 8
//   BSplineHessian2D                 dxx, dxy and dyy, by 16
//   BSplineDerivativesLoad2D         value, gradient and Hessian with exact weights, by 16 loads
//   BSplineSlope1D, BSplineSlope2D, BSplineBend1D    the fetches they are made of, for any kernel
//
// What lies outside is the sampler's; loads go on with the edge texel.
//
// Sigg 2005, sect. 20.4, listings 20-3 and 20-4
#ifndef BOXCAR_BSPLINE_GRADIENT_HLSLI
#define BOXCAR_BSPLINE_GRADIENT_HLSLI

#include "boxcar/bspline_sample.hlsli"

// What a spline is at a point, each a colour.
struct BSplineDerivatives2D
{
    float4 value;
    float4 dx;
    float4 dy;
    float4 dxx;
    float4 dxy;
    float4 dyy;
};

// BSplineDerivativesLoad2D: all derivatives up to the second.
//
//   edgeTexels  the point, in edge coordinates
//
// Error: 5 u of the largest texel.
// Cost:  16 loads.
BSplineDerivatives2D BSplineDerivativesLoad2D(Texture2D<float4> source, int2 extentTexels, float2 edgeTexels)
{
    BSplinePoint p = BSplinePointOf(edgeTexels);
    float4 x0 = BSplineWeights(p.t.x), x1 = BSplineWeights1(p.t.x), x2 = BSplineWeights2(p.t.x);
    float4 y0 = BSplineWeights(p.t.y), y1 = BSplineWeights1(p.t.y), y2 = BSplineWeights2(p.t.y);
    BSplineDerivatives2D d;
    d.value = d.dx = d.dy = d.dxx = d.dxy = d.dyy = (float4)0;
    [unroll]
    for (int y = 0; y < 4; y++)
    {
        float4 row = (float4)0, row1 = (float4)0, row2 = (float4)0;
        [unroll]
        for (int x = 0; x < 4; x++)
        {
            float4 texel = source.Load(int3(clamp(p.first + int2(x, y) - 1, 0, extentTexels - 1), 0));
            row += x0[x] * texel;
            row1 += x1[x] * texel;
            row2 += x2[x] * texel;
        }
        d.value += y0[y] * row;
        d.dx += y0[y] * row1;
        d.dxx += y0[y] * row2;
        d.dy += y1[y] * row;
        d.dxy += y1[y] * row1;
        d.dyy += y2[y] * row;
    }
    return d;
}

// BSplineSlope1D: the first derivative along x from a derivative's `hg`.
//
//   edgeTexels  the point, in edge coordinates
//   hg          BSplineHG1, or a lookup texture of it. Its .z is the second fetch's weight; the listing's is the first one's,
//               which is as large and of the other sign
//
// Cost: 2 linear fetches.
float4 BSplineSlope1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 hg)
{
    float2 first = TexelEdgeToUv(edgeTexels - float2(hg.x, 0.0), extentTexels);
    float2 second = TexelEdgeToUv(edgeTexels + float2(hg.y, 0.0), extentTexels);
    return hg.z * (source.SampleLevel(linearClamp, second, 0.0) - source.SampleLevel(linearClamp, first, 0.0));
}

// BSplineBend1D: the second derivative along x. It is piecewise linear, so fetches one texel apart are enough, and no weights
// are needed.
//
// Cost: 3 linear fetches.
float4 BSplineBend1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels)
{
    float2 uv = TexelEdgeToUv(edgeTexels, extentTexels), oneTexel = float2(1.0 / extentTexels.x, 0.0);
    float4 here = source.SampleLevel(linearClamp, uv, 0.0);
    return (source.SampleLevel(linearClamp, uv - oneTexel, 0.0) - here)
         + (source.SampleLevel(linearClamp, uv + oneTexel, 0.0) - here);
}

// BSplineSlope2D: the first derivatives from a kernel's `hg` along both axes and from its derivative's.
//
// Cost: 8 linear fetches.
void BSplineSlope2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 x, float3 y,
                    float3 x1, float3 y1, out float4 dx, out float4 dy)
{
    dx = lerp(BSplineSlope1D(source, linearClamp, extentTexels, edgeTexels - float2(0.0, y.x), x1),
              BSplineSlope1D(source, linearClamp, extentTexels, edgeTexels + float2(0.0, y.y), x1), y.z);
    dy = y1.z * (BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels + float2(0.0, y1.y), x, 0.0)
               - BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels - float2(0.0, y1.x), x, 0.0));
}

// BSplineFirst1D: the first derivative of a line.
//
//   uv  [0, 1] across the line in .x; a .y between texels mixes two lines
//
// Error: in float formats 9e-6 of the range at 256 texels (BSplineFetch.LinesAreNearTheSpline).
// Cost:  2 linear fetches.
float4 BSplineFirst1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    return BSplineSlope1D(source, linearClamp, extentTexels, edgeTexels, BSplineHG1(BSplinePointOf(edgeTexels).t.x));
}

// BSplineSecond1D: the second derivative of a line.
//
// Error: in float formats 3e-7 of the range where uv is exact (BSplineFetch.LinesAreNearTheSpline).
// Cost:  3 linear fetches.
float4 BSplineSecond1D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv)
{
    return BSplineBend1D(source, linearClamp, extentTexels, TexelUvToEdge(uv, extentTexels));
}

// BSplineGradient2D: the first derivatives of a picture.
//
//   uv      [0, 1] across the picture
//   dx, dy  per texel
//
// Error: in float formats 1e-5 of the range at 256 texels (BSpline.FewFetchesAreNearTheSpline).
// Cost:  8 linear fetches.
void BSplineGradient2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv, out float4 dx,
                       out float4 dy)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    float2 t = BSplinePointOf(edgeTexels).t;
    BSplineSlope2D(source, linearClamp, extentTexels, edgeTexels, BSplineHG(t.x), BSplineHG(t.y), BSplineHG1(t.x),
                   BSplineHG1(t.y), dx, dy);
}

// BSplineHessian2D: the second derivatives of a picture. (1, -2, 1) of linear fetches along the axis that is derived twice, two
// lines or columns of them for the other axis; the mixed one by first derivatives along both.
//
//   dxx, dxy, dyy  per texel squared
//
// Error: in float formats 1.8e-5 of the range at 256 texels (BSplineFetch.SecondDerivativesAreNearTheSpline).
// Cost:  16 linear fetches.
void BSplineHessian2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv, out float4 dxx,
                      out float4 dxy, out float4 dyy)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    float2 t = BSplinePointOf(edgeTexels).t;
    float3 x = BSplineHG(t.x), y = BSplineHG(t.y);
    float3 x1 = BSplineHG1(t.x), y1 = BSplineHG1(t.y);

    dxx = lerp(BSplineBend1D(source, linearClamp, extentTexels, edgeTexels - float2(0.0, y.x)),
               BSplineBend1D(source, linearClamp, extentTexels, edgeTexels + float2(0.0, y.y)), y.z);

    float4 above = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels - float2(0.0, 1.0), x, 0.0);
    float4 here = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels, x, 0.0);
    float4 below = BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels + float2(0.0, 1.0), x, 0.0);
    dyy = (above - here) + (below - here);

    dxy = y1.z * (BSplineSlope1D(source, linearClamp, extentTexels, edgeTexels + float2(0.0, y1.y), x1)
                - BSplineSlope1D(source, linearClamp, extentTexels, edgeTexels - float2(0.0, y1.x), x1));
}

#endif
