// bspline_volume.hlsli: volumes of one number a voxel under the cubic B-spline: value, gradient, Hessian, curvature.
//
//   BSplineSample3D    the value by 8 linear fetches: needs a format that is filtered with more than 8 bits of weight
//   BSplineLoad3D      the same by 64 loads, weights of floats
//   BSplineGradient3D  the gradient by 24 linear fetches
//   BSplineHessian3D   value, gradient and all second derivatives, by 64 loads
//   BSplineCurvature   the curvatures of the surface of one value, from gradient and Hessian
//
// Derivatives are per voxel. Where voxels have sides of h.x, h.y, h.z the gradient is divided by h, and each second derivative
// by both of its axes' (BSplineScaled).
//
// Sigg 2005, sect. 20.2 and 20.4; Kindlmann 2003 (curvature)
#ifndef BOXCAR_BSPLINE_VOLUME_HLSLI
#define BOXCAR_BSPLINE_VOLUME_HLSLI

#include "boxcar/bspline.hlsli"

// What a spline is at a point of a volume.
struct BSplineDerivatives3D
{
    float value;
    float3 gradient;  // dx, dy, dz
    float3 pure;      // dxx, dyy, dzz
    float3 mixed;     // dyz, dxz, dxy
};

// BSplineFetchesOf: the two fetches of an axis and the weight of each.
//
//   hg       the kernel at the point: BSplineHG, BSplineHGOf, BSplineHGLookup
//   returns  .x: how far before the point the first lies, .y: how far behind it the second, .z and .w: their weights
float4 BSplineFetchesOf(float3 hg)
{
    return float4(hg.xy, 1.0 - hg.z, hg.z);
}

// BSplineFetches1Of: the same for a derivative's kernel, such as BSplineHG1.
float4 BSplineFetches1Of(float3 hg)
{
    return float4(hg.xy, -hg.z, hg.z);
}

// BSplineFetch3D: the weighted sum of the eight linear fetches that three axes make.
//
// Cost: 8 linear fetches.
float BSplineFetch3D(Texture3D<float> source, SamplerState linearClamp, int3 extentTexels, float3 edgeTexels, float4 x, float4 y,
                     float4 z)
{
    float3 lo = (edgeTexels - float3(x.x, y.x, z.x)) / float3(extentTexels);
    float3 hi = (edgeTexels + float3(x.y, y.y, z.y)) / float3(extentTexels);
    float a = x.z * source.SampleLevel(linearClamp, lo, 0.0)
            + x.w * source.SampleLevel(linearClamp, float3(hi.x, lo.y, lo.z), 0.0);
    float b = x.z * source.SampleLevel(linearClamp, float3(lo.x, hi.y, lo.z), 0.0)
            + x.w * source.SampleLevel(linearClamp, float3(hi.x, hi.y, lo.z), 0.0);
    float c = x.z * source.SampleLevel(linearClamp, float3(lo.x, lo.y, hi.z), 0.0)
            + x.w * source.SampleLevel(linearClamp, float3(hi.x, lo.y, hi.z), 0.0);
    float d = x.z * source.SampleLevel(linearClamp, float3(lo.x, hi.y, hi.z), 0.0)
            + x.w * source.SampleLevel(linearClamp, hi, 0.0);
    return z.z * (y.z * a + y.w * b) + z.w * (y.z * c + y.w * d);
}

// BSplineSample3D: the cubic B-spline of a volume.
//
//   source        any number of voxels
//   linearClamp   linear filter; what lies outside is the sampler's: clamp goes on with the voxels of the sides
//   extentTexels  width, height, depth
//   uvw           [0, 1] across the volume; voxel centres at (i + 0.5) / extent
//   returns       in the source's units
//
// Error: in float formats 3e-6 of the range at 64 voxels a side, growing with the side: uvw holds the place in 24 bits
//        (BSplineVolume.EightFetchesAreNearTheSpline). The samplers of GPUs may have weights of 8 bits only.
// Cost:  8 linear fetches.
//
// Sigg 2005, sect. 20.2
float BSplineSample3D(Texture3D<float> source, SamplerState linearClamp, int3 extentTexels, float3 uvw)
{
    float3 edgeTexels = uvw * float3(extentTexels);
    float3 t = frac(edgeTexels - 0.5);
    return BSplineFetch3D(source, linearClamp, extentTexels, edgeTexels, BSplineFetchesOf(BSplineHG(t.x)),
                          BSplineFetchesOf(BSplineHG(t.y)),
                          BSplineFetchesOf(BSplineHG(t.z)));
}

// BSplineGradient3D: the first derivatives, per voxel. Each is derived along one axis and plain along the others, so that no
// two share a fetch.
//
// Error: in float formats 4e-6 of the range at 64 voxels a side (BSplineVolume.EightFetchesAreNearTheSpline).
// Cost:  24 linear fetches.
//
// Sigg 2005, sect. 20.4
float3 BSplineGradient3D(Texture3D<float> source, SamplerState linearClamp, int3 extentTexels, float3 uvw)
{
    float3 edgeTexels = uvw * float3(extentTexels);
    float3 t = frac(edgeTexels - 0.5);
    float4 x = BSplineFetchesOf(BSplineHG(t.x)), y = BSplineFetchesOf(BSplineHG(t.y)), z = BSplineFetchesOf(BSplineHG(t.z));
    return float3(BSplineFetch3D(source, linearClamp, extentTexels, edgeTexels, BSplineFetches1Of(BSplineHG1(t.x)), y, z),
                  BSplineFetch3D(source, linearClamp, extentTexels, edgeTexels, x, BSplineFetches1Of(BSplineHG1(t.y)), z),
                  BSplineFetch3D(source, linearClamp, extentTexels, edgeTexels, x, y, BSplineFetches1Of(BSplineHG1(t.z))));
}

// BSplineLoad3D: the spline with weights of floats, for formats that samplers filter with 8 bits. The voxels of the sides go
// on outside.
//
//   edgeTexels  the point: uvw times the extent
//
// Error: 3 u of the largest voxel (BSplineVolume.ExactWeightsAreTheSpline).
// Cost:  64 loads.
float BSplineLoad3D(Texture3D<float> source, int3 extentTexels, float3 edgeTexels)
{
    int3 first = int3(floor(edgeTexels - 0.5));
    float3 t = frac(edgeTexels - 0.5);
    float4 wx = BSplineWeights(t.x), wy = BSplineWeights(t.y), wz = BSplineWeights(t.z);
    float sum = 0.0;
    [unroll]
    for (int z = 0; z < 4; z++)
    {
        float slice = 0.0;
        [unroll]
        for (int y = 0; y < 4; y++)
        {
            float row = 0.0;
            [unroll]
            for (int x = 0; x < 4; x++)
                row += wx[x] * source.Load(int4(clamp(first + int3(x, y, z) - 1, 0, extentTexels - 1), 0));
            slice += wy[y] * row;
        }
        sum += wz[z] * slice;
    }
    return sum;
}

// BSplineHessian3D: the value and all derivatives up to the second, per voxel, with weights of floats.
//
// Error: 5 u of the largest voxel, 9 u for second derivatives (BSplineVolume.ExactWeightsAreTheSpline).
// Cost:  64 loads.
//
// Sigg 2005, sect. 20.4 (the Hessian; by 8 fetches a mixed and 12 a pure derivative there)
BSplineDerivatives3D BSplineHessian3D(Texture3D<float> source, int3 extentTexels, float3 edgeTexels)
{
    int3 first = int3(floor(edgeTexels - 0.5));
    float3 t = frac(edgeTexels - 0.5);
    float4 x0 = BSplineWeights(t.x), x1 = BSplineWeights1(t.x), x2 = BSplineWeights2(t.x);
    float4 y0 = BSplineWeights(t.y), y1 = BSplineWeights1(t.y), y2 = BSplineWeights2(t.y);
    float4 z0 = BSplineWeights(t.z), z1 = BSplineWeights1(t.z), z2 = BSplineWeights2(t.z);
    BSplineDerivatives3D d;
    d.value = 0.0;
    d.gradient = d.pure = d.mixed = float3(0.0, 0.0, 0.0);
    [unroll]
    for (int z = 0; z < 4; z++)
    {
        float s = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;  // of the slice
        [unroll]
        for (int y = 0; y < 4; y++)
        {
            float r = 0.0, rx = 0.0, rxx = 0.0;  // of the row
            [unroll]
            for (int x = 0; x < 4; x++)
            {
                float voxel = source.Load(int4(clamp(first + int3(x, y, z) - 1, 0, extentTexels - 1), 0));
                r += x0[x] * voxel;
                rx += x1[x] * voxel;
                rxx += x2[x] * voxel;
            }
            s += y0[y] * r;
            sx += y0[y] * rx;
            sxx += y0[y] * rxx;
            sy += y1[y] * r;
            sxy += y1[y] * rx;
            syy += y2[y] * r;
        }
        d.value += z0[z] * s;
        d.gradient += float3(z0[z] * sx, z0[z] * sy, z1[z] * s);
        d.pure += float3(z0[z] * sxx, z0[z] * syy, z2[z] * s);
        d.mixed += float3(z1[z] * sy, z1[z] * sx, z0[z] * sxy);
    }
    return d;
}

// BSplineScaled: derivatives per unit of length, where a voxel's sides are `sides` units.
BSplineDerivatives3D BSplineScaled(BSplineDerivatives3D d, float3 sides)
{
    d.gradient /= sides;
    d.pure /= sides * sides;
    d.mixed /= sides.yxx * sides.zzy;
    return d;
}

// BSplineCurvature: the principal curvatures of the surface of one value.
//
//   gradient, pure, mixed  as in BSplineDerivatives3D, all per the same unit of length
//   returns                .x >= .y, per that unit; 0 where the gradient is 0
//
// Signs: the surface's outside is where values fall, so its normal is -gradient / |gradient|, and a bright ball of radius r has
// 1 / r twice. Ridges have a large .x, valleys a very negative .y.
//
// Kindlmann 2003 (G = -P H P / |g|, here in a basis of the plane that P projects to: its two eigenvalues without the
// cancellation in 2 |G|^2 - trace^2)
float2 BSplineCurvature(float3 gradient, float3 pure, float3 mixed)
{
    float slope = length(gradient);
    float3 n = -gradient / max(slope, 1e-30);
    // Of the axes the one that n has least of is far from parallel to it.
    float3 a = abs(n);
    float3 axis = a.x <= a.y && a.x <= a.z ? float3(1.0, 0.0, 0.0)
                : a.y <= a.z               ? float3(0.0, 1.0, 0.0)
                                           : float3(0.0, 0.0, 1.0);
    float3 u = normalize(cross(n, axis));
    float3 v = cross(n, u);
    float3 hu = pure * u + float3(mixed.z * u.y + mixed.y * u.z, mixed.z * u.x + mixed.x * u.z, mixed.y * u.x + mixed.x * u.y);
    float3 hv = pure * v + float3(mixed.z * v.y + mixed.y * v.z, mixed.z * v.x + mixed.x * v.z, mixed.y * v.x + mixed.x * v.y);
    float uu = dot(u, hu), uv = dot(u, hv), vv = dot(v, hv);
    float mean = -0.5 * (uu + vv);
    float spread = sqrt(0.25 * (uu - vv) * (uu - vv) + uv * uv);
    return slope > 0.0 ? float2(mean + spread, mean - spread) / slope : float2(0.0, 0.0);
}

#endif
