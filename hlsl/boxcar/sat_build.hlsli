// sat_build.hlsli: the arithmetic of one pass of building a summed-area table by recursive doubling.
//
// A pass with r taps adds the r texels at distances 0, 1, .., r - 1 strides to the left (or upwards):
//
//   out(x) = in(x) + in(x - s) + .. + in(x - (r - 1) s),     s = r^i texels in pass i
//
// After P passes along an axis of n texels, r^P >= n, every texel holds the sum of all before it. Texels outside the
// image count as 0. The taps are added as a balanced tree, pairs first: with 2, 4, 8 and 16 taps that is one and the
// same tree, so the four tables agree bit for bit (SummedAreaTable.EveryTapsGivesTheSameBits).
//
//   SATPass2/4/8/16       by interpolated uv, two to a float4: as printed
//   SATPassLoad2/4/8/16   by integer address
//
// Hensley 2005, sect. 3; Scheuermann 2005 (SATPass)
#ifndef BOXCAR_SAT_BUILD_HLSLI
#define BOXCAR_SAT_BUILD_HLSLI

// SATPass2 .. SATPass16: one pass by uv.
//
//   source         what the last pass wrote, or the image itself
//   nearestBorder  nearest filter, clamped to a border colour of 0. A linear filter would not return texels exactly.
//   uv[k]          .xy is the centre of the texel 2k strides away, .wz of the one 2k + 1 strides away (.w is u)
//
// Cost:  one sample a tap.
float4 SATPass2(Texture2D<float4> source, SamplerState nearestBorder, float4 uv)
{
    return source.Sample(nearestBorder, uv.xy) + source.Sample(nearestBorder, uv.wz);
}

float4 SATPass4(Texture2D<float4> source, SamplerState nearestBorder, float4 uv[2])
{
    return SATPass2(source, nearestBorder, uv[0]) + SATPass2(source, nearestBorder, uv[1]);
}

float4 SATPass8(Texture2D<float4> source, SamplerState nearestBorder, float4 uv[4])
{
    float4 t[4];
    t[0] = SATPass2(source, nearestBorder, uv[0]);
    t[1] = SATPass2(source, nearestBorder, uv[1]);
    t[2] = SATPass2(source, nearestBorder, uv[2]);
    t[3] = SATPass2(source, nearestBorder, uv[3]);
    return (t[0] + t[1]) + (t[2] + t[3]);
}

float4 SATPass16(Texture2D<float4> source, SamplerState nearestBorder, float4 uv[8])
{
    float4 t[8];
    [unroll]
    for (int i = 0; i < 8; i++)
        t[i] = SATPass2(source, nearestBorder, uv[i]);

    t[0] += t[1]; t[2] += t[3];
    t[4] += t[5]; t[6] += t[7];
    t[0] += t[2]; t[4] += t[6];
    return t[0] + t[4];
}

// SATPassLoad2 .. SATPassLoad16: one pass by integer address.
//
//   source        what the last pass wrote, or the image itself
//   texel         the texel that is written; 0 <= texel < extent
//   strideTexels  (s, 0) along x, (0, s) along y
//
// Cost:  one load a tap. Addresses left of or above the image are clamped to it and their value replaced by 0.
float4 SATPassLoad1(Texture2D<float4> source, int2 texel)
{
    float4 value = source.Load(int3(max(texel, 0), 0));
    return (texel.x >= 0 && texel.y >= 0) ? value : (float4)0;
}

float4 SATPassLoad2(Texture2D<float4> source, int2 texel, int2 strideTexels)
{
    return SATPassLoad1(source, texel) + SATPassLoad1(source, texel - strideTexels);
}

float4 SATPassLoad4(Texture2D<float4> source, int2 texel, int2 strideTexels)
{
    return SATPassLoad2(source, texel, strideTexels) + SATPassLoad2(source, texel - 2 * strideTexels, strideTexels);
}

float4 SATPassLoad8(Texture2D<float4> source, int2 texel, int2 strideTexels)
{
    return SATPassLoad4(source, texel, strideTexels) + SATPassLoad4(source, texel - 4 * strideTexels, strideTexels);
}

float4 SATPassLoad16(Texture2D<float4> source, int2 texel, int2 strideTexels)
{
    return SATPassLoad8(source, texel, strideTexels) + SATPassLoad8(source, texel - 8 * strideTexels, strideTexels);
}

#endif
