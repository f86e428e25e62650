// bspline_gradient.hlsli: derivatives of a picture under the cubic B-spline, per texel.
//
//   BSplineGradient2D        dx and dy, by 8 linear fetches
//   BSplineDerivativesLoad2D value, gradient and Hessian with exact weights, by 16 loads
//
// Sigg 2005, sect. 20.4 (first derivatives by two fetches a line; the listing's share is the first fetch's, -z here)
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

// BSplineSlope2D: one linear fetch form along an axis: the value of `hg` across x and y where `isDerived` says that the axis
// is derived.
float4 BSplineSlope2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 edgeTexels, float3 x,
                      float3 y, bool alongX)
{
    float2 lo = TexelEdgeToUv(edgeTexels - float2(x.x, y.x), extentTexels);
    float2 hi = TexelEdgeToUv(edgeTexels + float2(x.y, y.y), extentTexels);
    float4 a = source.SampleLevel(linearClamp, lo, 0.0);
    float4 b = source.SampleLevel(linearClamp, float2(hi.x, lo.y), 0.0);
    float4 c = source.SampleLevel(linearClamp, float2(lo.x, hi.y), 0.0);
    float4 d = source.SampleLevel(linearClamp, hi, 0.0);
    float4 slope = lerp(c, d, x.z) - lerp(a, b, x.z);
    if (alongX)
        slope = lerp(b - a, d - c, y.z);
    return (alongX ? x.z : y.z) * slope;
}

// BSplineGradient2D: the first derivatives.
//
//   dx, dy  per texel
//
// Error: in float formats 8e-6 of the range at 256 texels (BSpline.FewFetchesAreNearTheSpline).
// Cost:  8 linear fetches.
void BSplineGradient2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv, out float4 dx,
                       out float4 dy)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    BSplinePoint p = BSplinePointOf(edgeTexels);
    dx = BSplineSlope2D(source, linearClamp, extentTexels, edgeTexels, BSplineHG1(p.t.x), BSplineHG(p.t.y), true);
    dy = BSplineSlope2D(source, linearClamp, extentTexels, edgeTexels, BSplineHG(p.t.x), BSplineHG1(p.t.y), false);
}

#endif
