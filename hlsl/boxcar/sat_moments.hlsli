// sat_moments.hlsli: mean and variance over a box, from an exact table of codes and their squares.
//
// The variance of numbers that lie close together is the small difference of two large sums: floats keep nothing of
// it. In integers it is exact; and taken about a whole number next to the mean, what goes on to floats is small.
//
//   SATMomentsOf    the mean and the variance of the codes over a box
//   SATUpperShare   how much of the box can lie beyond a value (Chebyshev)
//
// Beyond the papers: variance shadow maps over Crow's table
#ifndef BOXCAR_SAT_MOMENTS_HLSLI
#define BOXCAR_SAT_MOMENTS_HLSLI

#include "boxcar/sat_exact.hlsli"

struct SATMoments
{
    float mean;      // in codes
    float variance;  // in codes squared; 0 at least
};

SATWide SATWideSplat(SATWide a, int channel)
{
    uint low = a.low[channel], high = a.high[channel];
    return SATWideOf(uint4(low, low, low, low), uint4(high, high, high, high));
}

SATWide SATWideOfCount(int count)
{
    uint n = uint(count);
    return SATWideOf(uint4(n, n, n, n), uint4(0u, 0u, 0u, 0u));
}

// SATMomentsOf: weighted by coverage where an edge cuts a texel.
//
//   table    two words, not signed: codes below 2^16 in x, their squares in y; origin (0, 0)
//   frame    how it lies over the image; CLIP
//   box      from SATClipBox; not empty
//
// Range:  boxes of up to 2^31 texels.
// Error:  mean 0.005 codes; variance 2e-6 of it and of one code squared
//         (SATMoments.AreThoseOfTheDefinitionOverAnyBox).
// Cost:   20 loads a word.
SATMoments SATMomentsOf(SATExactTable table, SATFrame frame, SATBox box)
{
    SATStretches x = SATStretchesOf(box.loTexels.x, box.hiTexels.x);
    SATStretches y = SATStretchesOf(box.loTexels.y, box.hiTexels.y);

    // A whole number near the mean: that of all texels which the box touches.
    int2 outerLo = max(int2(x.corner.x, y.corner.x), 0);
    int2 outerHi = min(int2(x.corner.w, y.corner.w), frame.extentTexels);
    int2 outerSize = outerHi - outerLo;
    float4 outer = SATWideToFloat(SATSumTexels(table, frame, outerLo, outerHi), 2, false);
    int middle = int(floor(outer.x / (float(outerSize.x) * float(outerSize.y)) + 0.5));

    SATWide zero = SATWideOf(uint4(0u, 0u, 0u, 0u), uint4(0u, 0u, 0u, 0u));
    SATWide above[4] = { zero, zero, zero, zero };
    float first = 0.0;   // of q - middle
    float second = 0.0;  // of (q - middle)^2
    [loop]
    for (int row = 0; row < 4; row++)
    {
        SATWide left = zero;
        [loop]
        for (int column = 0; column < 4; column++)
        {
            SATWide corner = SATLoadCorner(table, frame, int2(x.corner[column], y.corner[row]));
            SATWide strip = SATWideSub(corner, left);
            if (row > 0 && column > 0)
            {
                float weight = x.weight.high[column - 1] * y.weight.high[row - 1];
                int texels = (x.corner[column] - x.corner[column - 1]) * (y.corner[row] - y.corner[row - 1]);
                SATWide sums = SATWideSub(strip, above[column]);
                SATWide codes = SATWideSplat(sums, 0), squares = SATWideSplat(sums, 1);
                SATWide count = SATWideScale(SATWideOfCount(texels), middle);
                SATWide about = SATWideSub(codes, count);
                // sum q^2 - 2 m sum q + n m^2 = sum q^2 - m (sum q + sum (q - m))
                SATWide spread = SATWideSub(squares, SATWideScale(SATWideAdd(codes, about), middle));
                first += weight * SATWideToFloat(about, 2, true).x;
                second += weight * SATWideToFloat(spread, 2, true).x;
            }
            above[column] = strip;
            left = corner;
        }
    }
    float areaTexels = SATBoxArea(box);
    float offset = first / areaTexels;
    SATMoments m;
    m.mean = float(middle) + offset;
    m.variance = max(second / areaTexels - offset * offset, 0.0);
    return m;
}

// SATUpperShare: the most of numbers with these moments that can be `value` or more; 1 where the mean is.
// Where there are two numbers only, and `value` is the larger, it is the share of the larger one.
//
//   variance  more than 0 where the mean may be below `value`
//
// Cost: 6 operations. Chebyshev (Cantelli)
float SATUpperShare(SATMoments moments, float value)
{
    float below = max(value - moments.mean, 0.0);
    return below > 0.0 ? moments.variance / (moments.variance + below * below) : 1.0;
}

#endif
