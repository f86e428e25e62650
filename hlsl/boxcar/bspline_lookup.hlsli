// bspline_lookup.hlsli: third-order filters with the kernel in a lookup texture, as the chapter has it.
//
//   BSplineHGLookup          what the texture holds at t: instead of BSplineHG(t)
//   BSplineSampleLookup1D    2 linear fetches and 1 of the lookup texture
//   BSplineSampleLookup2D    4 and 2
//   BSplineGradientLookup2D  first derivatives of a picture, 8 and 4
//   BSplineSampleLookup3D    8 and 3
//
// runtime/passes/bspline_lookup.h makes the textures: one of the value, one of the first derivative, one of a Gaussian. The
// functions know no kernel. docs/third-order.md has what sizes and formats cost; today arithmetic is as fast and exact.
//
// Sigg 2005, sect. 20.2 and 20.4
#ifndef BOXCAR_BSPLINE_LOOKUP_HLSLI
#define BOXCAR_BSPLINE_LOOKUP_HLSLI

#include "boxcar/bspline_gradient.hlsli"
#include "boxcar/bspline_volume.hlsli"

// BSplineHGLookup: offsets and share of a kernel's two fetches.
//
//   hg           one texel high; its first texel holds t = 0, its last one t = 1
//   linearClamp  linear filter
//   sizeTexels   its width, 2 at least
//   t            0 to 1
//   returns      as BSplineHG
//
// The chapter repeats the texture, so that no fraction has to be taken; but the offsets jump from t = 1 to t = 0, and the
// linear filter blurs the jump: errors of 0.2 (BSplineLookup.ARepeatedTextureBlursTheJump).
//
// Error: float32, 128 texels: 1.4e-5 of the result's range (BSplineLookup.SizesAndFormats).
// Cost:  1 fetch.
float3 BSplineHGLookup(Texture2D<float4> hg, SamplerState linearClamp, int sizeTexels, float t)
{
    float centreTexels = t * (sizeTexels - 1) + 0.5;
    return hg.SampleLevel(linearClamp, float2(centreTexels / sizeTexels, 0.5), 0.0).xyz;
}

// BSplineSampleLookup1D: a kernel along x.
//
// Cost: 2 linear fetches and 1 of hg.
//
// Sigg 2005, listing 20-1
float4 BSplineSampleLookup1D(Texture2D<float4> source, Texture2D<float4> hg, SamplerState linearClamp, int2 extentTexels,
                             int sizeTexels, float2 uv)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    float3 x = BSplineHGLookup(hg, linearClamp, sizeTexels, BSplinePointOf(edgeTexels).t.x);
    return BSplineFetch1D(source, linearClamp, extentTexels, edgeTexels, x, 0.0);
}

// BSplineSampleLookup2D: a kernel along both axes.
//
// Cost: 4 linear fetches and 2 of hg.
//
// Sigg 2005, listing 20-2
float4 BSplineSampleLookup2D(Texture2D<float4> source, Texture2D<float4> hg, SamplerState linearClamp, int2 extentTexels,
                             int sizeTexels, float2 uv)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    float2 t = BSplinePointOf(edgeTexels).t;
    float3 x = BSplineHGLookup(hg, linearClamp, sizeTexels, t.x);
    float3 y = BSplineHGLookup(hg, linearClamp, sizeTexels, t.y);
    return BSplineFetch2D(source, linearClamp, extentTexels, edgeTexels, x, y, 0.0);
}

// BSplineGradientLookup2D: the first derivatives.
//
//   hg, hg1  lookup textures of the value and of the first derivative, of one size
//   dx, dy   per texel
//
// Cost: 8 linear fetches and 4 of the lookup textures.
//
// Sigg 2005, sect. 20.4
void BSplineGradientLookup2D(Texture2D<float4> source, Texture2D<float4> hg, Texture2D<float4> hg1, SamplerState linearClamp,
                          int2 extentTexels, int sizeTexels, float2 uv, out float4 dx, out float4 dy)
{
    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    float2 t = BSplinePointOf(edgeTexels).t;
    float3 x = BSplineHGLookup(hg, linearClamp, sizeTexels, t.x), y = BSplineHGLookup(hg, linearClamp, sizeTexels, t.y);
    float3 x1 = BSplineHGLookup(hg1, linearClamp, sizeTexels, t.x), y1 = BSplineHGLookup(hg1, linearClamp, sizeTexels, t.y);
    BSplineSlope2D(source, linearClamp, extentTexels, edgeTexels, x, y, x1, y1, dx, dy);
}

// BSplineSampleLookup3D: a kernel along the three axes of a volume.
//
//   uvw  [0, 1] across the volume
//
// Cost: 8 linear fetches and 3 of hg.
//
// Sigg 2005, sect. 20.2
float BSplineSampleLookup3D(Texture3D<float> source, Texture2D<float4> hg, SamplerState linearClamp, int3 extentTexels,
                            int sizeTexels, float3 uvw)
{
    float3 edgeTexels = uvw * float3(extentTexels);
    float3 t = frac(edgeTexels - 0.5);
    return BSplineFetch3D(source, linearClamp, extentTexels, edgeTexels,
                          BSplineFetchesOf(BSplineHGLookup(hg, linearClamp, sizeTexels, t.x)),
                          BSplineFetchesOf(BSplineHGLookup(hg, linearClamp, sizeTexels, t.y)),
                          BSplineFetchesOf(BSplineHGLookup(hg, linearClamp, sizeTexels, t.z)));
}

#endif
