// bspline_kernels.hlsli: other kernels in the shape of the cubic's weights and fetches: one shader takes them all.
//
//   BSplineWeightsOfDegree, BSplineHGOfDegree  the nearest texel and linear interpolation, the B-splines of degree 0 and 1
//   GaussianWeights1                           of the first derivative of GaussianWeights' sum
//
// Weights are those of texels i - 1 .. i + 2; bspline_sample.hlsli fetches. Degree 2 is none of them: its three texels lie about
// the nearest one.
//
// Sigg 2005, sect. 20.1 and 20.6
#ifndef BOXCAR_BSPLINE_KERNELS_HLSLI
#define BOXCAR_BSPLINE_KERNELS_HLSLI

#include "boxcar/bspline.hlsli"

// BSplineWeightsOfDegree: the weights of BSplineWeights, for other degrees.
//
//   degree  0, 1 or 3
//   t       0 to 1; half way between two texels the second one is the nearest
float4 BSplineWeightsOfDegree(int degree, float t)
{
    float second = degree == 0 ? step(0.5, t) : t;
    float4 weights = float4(0.0, 1.0 - second, second, 0.0);
    if (degree == 3)
        weights = BSplineWeights(t);
    return weights;
}

// BSplineHGOfDegree: fetches at x - .x and x + .y, mixed by .z, as BSplineHG has them. Both lie on texels for degrees 0 and
// 1, so no sampler rounds anything; BSplineHGOf would divide 0 by 0 at t = 0.
//
//   degree  0, 1 or 3
float3 BSplineHGOfDegree(int degree, float t)
{
    float3 hg = float3(t, 1.0 - t, degree == 0 ? step(0.5, t) : t);
    if (degree == 3)
        hg = BSplineHG(t);
    return hg;
}

// GaussianWeights1: the derivative of GaussianWeights by t. Like the spline's they add up to 0, the first two are 0 or less, the
// others 0 or more: so BSplineHGOf makes two fetches of them.
//
//   sigmaTexels  0.3 to 0.8
float4 GaussianWeights1(float t, float sigmaTexels)
{
    float4 weights = GaussianWeights(t, sigmaTexels);
    float4 fromTexel = float4(1.0 + t, t, t - 1.0, t - 2.0);
    return weights * (dot(weights, fromTexel) - fromTexel) / (sigmaTexels * sigmaTexels);
}

#endif
