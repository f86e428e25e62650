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
// The sums may also start elsewhere, at an origin inside the image (a corner of texels): texels right of it add to
// their left, texels left of it to their right, and likewise above and below.
//
//   SATPass2/4/8/16       by interpolated uv, two to a float4: as printed; origin (0, 0)
//   SATPassLoad2/4/8/16   by integer address
//   SATPassLoad           by integer address, in integers: there the order of additions is all one
//
// Hensley 2005, sect. 3; Scheuermann 2005 (SATPass)
#ifndef BOXCAR_SAT_BUILD_HLSLI
#define BOXCAR_SAT_BUILD_HLSLI

#include "boxcar/sat_exact.hlsli"

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

// SATTaps: where the taps of a texel lie.
struct SATTaps
{
    int2 texel;         // the texel that is written
    int2 originTexels;  // the corner that the sums start from
    int2 strideTexels;  // from one tap to the next, away from the texel and towards the origin
};

// SATTapsOf: the taps of a pass.
//
//   strideTexels  (s, 0) along x, (0, s) along y
SATTaps SATTapsOf(int2 texel, int2 originTexels, int2 strideTexels)
{
    SATTaps taps;
    taps.texel = texel;
    taps.originTexels = originTexels;
    taps.strideTexels = int2(texel.x < originTexels.x ? strideTexels.x : -strideTexels.x,
                             texel.y < originTexels.y ? strideTexels.y : -strideTexels.y);
    return taps;
}

// SATTapCounts: whether tap number i lies between the texel and the origin; what lies beyond it is 0.
bool SATTapCounts(SATTaps taps, int i)
{
    int2 at = taps.texel + i * taps.strideTexels;
    int2 origin = taps.originTexels;
    return (at.x < origin.x) == (taps.texel.x < origin.x) && (at.y < origin.y) == (taps.texel.y < origin.y);
}

// SATPassLoad2 .. SATPassLoad16: one pass by integer address, from tap number i on.
//
//   source   what the last pass wrote, or the image itself
//
// Cost:  one load a tap. Taps beyond the origin load the texel itself, and their value is replaced by 0.
float4 SATPassLoad1(Texture2D<float4> source, SATTaps taps, int i)
{
    bool counts = SATTapCounts(taps, i);
    float4 value = source.Load(int3(taps.texel + (counts ? i : 0) * taps.strideTexels, 0));
    return counts ? value : (float4)0;
}

float4 SATPassLoad2(Texture2D<float4> source, SATTaps taps, int i)
{
    return SATPassLoad1(source, taps, i) + SATPassLoad1(source, taps, i + 1);
}

float4 SATPassLoad4(Texture2D<float4> source, SATTaps taps, int i)
{
    return SATPassLoad2(source, taps, i) + SATPassLoad2(source, taps, i + 2);
}

float4 SATPassLoad8(Texture2D<float4> source, SATTaps taps, int i)
{
    return SATPassLoad4(source, taps, i) + SATPassLoad4(source, taps, i + 4);
}

float4 SATPassLoad16(Texture2D<float4> source, SATTaps taps, int i)
{
    return SATPassLoad8(source, taps, i) + SATPassLoad8(source, taps, i + 8);
}

// SATPassLoad: one pass in integers modulo 2^32 or 2^64.
//
//   source  what the last pass wrote, or the image itself
//   count   taps
//
// Cost:  one load a tap and word.
SATWide SATPassLoad(SATExactTable source, SATTaps taps, int count)
{
    SATWide sum = SATWideOf(uint4(0u, 0u, 0u, 0u), uint4(0u, 0u, 0u, 0u));
    [unroll]
    for (int i = 0; i < count; i++)
    {
        uint counts = SATTapCounts(taps, i) ? 1u : 0u;
        int3 at = int3(taps.texel + int(counts) * i * taps.strideTexels, 0);
        SATWide value = SATWideOf(counts * source.low.Load(at), uint4(0u, 0u, 0u, 0u));
        if (source.words == 2)
            value.high = counts * source.high.Load(at);
        sum = SATWideAdd(sum, value);
    }
    return sum;
}

#endif
