// bspline.hlsli: the cubic B-spline and its derivatives as pure functions: weights, and where to fetch with them.
//
// A point x of a line of texels, counted in texels from the first one's centre, lies between texels i = floor(x) and
// i + 1, at t = x - i. The spline there is the sum of texels i - 1 .. i + 2 times four weights. Two neighbours with weights
// of one sign are one linear fetch between them: so the sum is two fetches on a line, four in a picture, eight in a volume.
//
//   BSplineWeights, BSplineWeights1, BSplineWeights2    of the value, the first and the second derivative
//   BSplineHG, BSplineHG1                               the two fetches: offsets and share
//   BSplineHGOf                                         the same for any four weights, such as GaussianWeights
//   CatmullRomWeights                                   of the cubic that goes through the texels
//   BSplineKernel, CatmullRomKernel                     of one texel, by its distance
//
// Derivatives are per texel: times the picture's size they are per uv. bspline_sample.hlsli and bspline_gradient.hlsli fetch.
//
// Sigg 2005, sect. 20.1 to 20.4
#ifndef BOXCAR_BSPLINE_HLSLI
#define BOXCAR_BSPLINE_HLSLI

// BSplineWeights: of texels i - 1 .. i + 2.
//
//   t        0 to 1
//   returns  four weights, 0 or more, that add up to 1
//
// Error: 2 u.
float4 BSplineWeights(float t)
{
    float s = 1.0 - t;
    return float4(s * s * s, 4.0 - 3.0 * t * t * (2.0 - t), 4.0 - 3.0 * s * s * (2.0 - s), t * t * t) / 6.0;
}

// BSplineWeights1: of the first derivative. They add up to 0; the first two are 0 or less, the others 0 or more.
float4 BSplineWeights1(float t)
{
    float s = 1.0 - t;
    return 0.5 * float4(-s * s, t * (3.0 * t - 4.0), s * (4.0 - 3.0 * s), t * t);
}

// BSplineWeights2: of the second derivative: linear interpolation of second differences.
float4 BSplineWeights2(float t)
{
    float s = 1.0 - t;
    return float4(s, 3.0 * t - 2.0, 3.0 * s - 2.0, t);
}

// BSplineHGOf: two linear fetches that make a sum of four texels.
//
//   weights  the first two of one sign, and the last two of one sign, neither pair 0
//   t        0 to 1
//   returns  .x: how far before x the first fetch lies, .y: how far behind x the second, .z: weight of the second;
//            the first has what is left of the weights' sum
//
// Sigg 2005, eq. 5
float3 BSplineHGOf(float4 weights, float t)
{
    float2 pairs = float2(weights.x + weights.y, weights.z + weights.w);
    return float3(1.0 - weights.y / pairs.x + t, 1.0 + weights.w / pairs.y - t, pairs.y);
}

// BSplineHG: for the value: fetches at x - .x and x + .y, mixed by .z.
float3 BSplineHG(float t)
{
    return BSplineHGOf(BSplineWeights(t), t);
}

// BSplineHG1: for the first derivative: .z times the difference of the fetches at x + .y and x - .x.
float3 BSplineHG1(float t)
{
    return BSplineHGOf(BSplineWeights1(t), t);
}

// GaussianWeights: a Gaussian at the four texels, made to add up to 1: another kernel for the same fetches.
//
//   sigmaTexels  0.3 to 0.8; more does not fit into four texels
//
// Sigg 2005, sect. 20.6 (any kernel of that support)
float4 GaussianWeights(float t, float sigmaTexels)
{
    float4 distance = float4(1.0 + t, t, 1.0 - t, 2.0 - t);
    float4 weights = exp(-0.5 * distance * distance / (sigmaTexels * sigmaTexels));
    return weights / (weights.x + weights.y + weights.z + weights.w);
}

// CatmullRomWeights: of the cubic through the texels with the slopes of their neighbours' differences. The outer weights are
// 0 or less, so only the middle pair is one fetch.
float4 CatmullRomWeights(float t)
{
    float s = 1.0 - t;
    return 0.5 * float4(-t * s * s, 2.0 + t * t * (3.0 * t - 5.0), 2.0 + s * s * (3.0 * s - 5.0), -s * t * t);
}

// BSplineKernel: the weight of a texel so many texels away.
//
// Error: 1 u.
float BSplineKernel(float distanceTexels)
{
    float a = abs(distanceTexels);
    float outer = saturate(0.5 * (2.0 - a)), inner = saturate(1.0 - a);
    return (8.0 * outer * outer * outer - 4.0 * inner * inner * inner) / 6.0;
}

// CatmullRomKernel: the weight of a texel so many texels away; exactly 1 at 0 and 0 at every other texel.
float CatmullRomKernel(float distanceTexels)
{
    float a = min(abs(distanceTexels), 2.0);
    return a < 1.0 ? (1.5 * a - 2.5) * a * a + 1.0 : ((2.5 - 0.5 * a) * a - 4.0) * a + 2.0;
}

#endif
