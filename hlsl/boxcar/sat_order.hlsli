// sat_order.hlsli: tent and parabolic filters from tables of second and third order.
//
// S_n is the summed-area table taken n times. Differences of it over the width W, n times on either axis, give the image
// filtered by n boxes of width W one after the other: a box, a tent (2 W wide), a parabolic filter (3 W wide):
//
//   sum over j = 0..n of (-1)^j C(n, j) S_n[e - j W],    on x and on y
//
// Tables of floats have no digits left for this; integers modulo 2^32 or 2^64 do it exactly (sat_exact.hlsli).
//
//   SATSumWhole      whole W on whole texels: (n + 1)^2 loads a word, exact
//   SATSumOrder      any W about any point, n = 2, 3: 121 and 361 loads a word
//   SATMassFull, SATMassWhole, SATMassOrder    what the kernel's weights add up to on one axis, inside the image
//
// A whole W that SATSumWhole can take is the box of W texels taken n times over texels. SATSumOrder is the integral of
// the kernel over the image as a function that is constant on each texel; it is continuous in W and in the point.
//
// Heckbert 1986; Hensley 2005, sect. 2.2
#ifndef BOXCAR_SAT_ORDER_HLSLI
#define BOXCAR_SAT_ORDER_HLSLI

#include "boxcar/sat_exact.hlsli"

// SATContinue: a table of order n continues as a polynomial of degree n - 1 where nothing is added any more. The weights
// of the last n entries (the last one first) in the entry that comes `ahead` texels after them; `ahead` may be negative:
// that is what a table would hold if nothing lay before. |ahead| <= 46340, so that the weights fit.
int3 SATContinue(int order, int ahead)
{
    if (order == 1)
        return int3(1, 0, 0);
    if (order == 2)
        return int3(1 + ahead, -ahead, 0);
    int twice = ahead * (ahead + 1) / 2;
    return int3(1 + ahead + twice, -ahead - 2 * twice, twice);
}

// SATLoadOrder: an entry of a table of order n, anywhere: 0 left of and above the image, continued right of and below it.
//
// Cost: 1 load a word inside, n where one index is beyond the image, n^2 where both are.
SATWide SATLoadOrder(SATExactTable table, int2 extentTexels, int order, int2 texel)
{
    int2 beyond = max(texel - (extentTexels - 1), 0);
    SATWide sum = SATLoadEntry(table, extentTexels, texel);
    if (beyond.x > 0 || beyond.y > 0)
    {
        int3 wx = beyond.x > 0 ? SATContinue(order, beyond.x) : int3(1, 0, 0);
        int3 wy = beyond.y > 0 ? SATContinue(order, beyond.y) : int3(1, 0, 0);
        int2 last = min(texel, extentTexels - 1);
        sum = SATWideOf(uint4(0u, 0u, 0u, 0u), uint4(0u, 0u, 0u, 0u));
        for (int y = 0; y < (beyond.y > 0 ? order : 1); y++)
        {
            SATWide row = SATWideOf(uint4(0u, 0u, 0u, 0u), uint4(0u, 0u, 0u, 0u));
            for (int x = 0; x < (beyond.x > 0 ? order : 1); x++)
                row = SATWideAdd(row, SATWideScale(SATLoadEntry(table, extentTexels, last - int2(x, y)), wx[x]));
            sum = SATWideAdd(sum, SATWideScale(row, wy[y]));
        }
    }
    return sum;
}

// SATBinomial: (-1)^j C(order, j), the weights of the n-th difference.
int SATBinomial(int order, int j)
{
    int magnitude = (j == 0 || j == order) ? 1 : order;  // for orders up to 3
    return (j & 1) != 0 ? -magnitude : magnitude;
}

// SATSumWhole: the sum of codes times the whole-number weights of n boxes of whole widths.
//
//   table         of order n, of integers
//   extentTexels  (W, H)
//   order         1, 2, 3
//   texel         the kernel's middle
//   sizeTexels    of the boxes; order * (sizeTexels - 1) must be even on both axes: odd widths, or tents
//   returns       modulo 2^32 or 2^64; the image is 0 outside
//
// Range:  exact while the sum fits into the words (SATBoxIsExact).
// Cost:   4, 9, 16 loads a word; more at the right and bottom rim (SATLoadOrder).
//
// Hensley 2005, sect. 2 (the second-order filter, with its two -1 as +1)
SATWide SATSumWhole(SATExactTable table, int2 extentTexels, int order, int2 texel, int2 sizeTexels)
{
    int2 end = texel + order * (sizeTexels - 1) / 2;
    SATWide sum = SATWideOf(uint4(0u, 0u, 0u, 0u), uint4(0u, 0u, 0u, 0u));
    for (int y = 0; y <= order; y++)
    {
        SATWide row = SATWideOf(uint4(0u, 0u, 0u, 0u), uint4(0u, 0u, 0u, 0u));
        for (int x = 0; x <= order; x++)
            row = SATWideAdd(row, SATWideScale(SATLoadOrder(table, extentTexels, order, end - int2(x, y) * sizeTexels),
                                               SATBinomial(order, x)));
        sum = SATWideAdd(sum, SATWideScale(row, SATBinomial(order, y)));
    }
    return sum;
}

// SATMassFull: what a kernel's weights add up to on one axis when all of it is inside: widthTexels^order.
float SATMassFull(int order, float widthTexels)
{
    float square = widthTexels * widthTexels;
    return order == 1 ? widthTexels : order == 2 ? square : square * widthTexels;
}

// SATWholeSide: what the first `texels` weights of a whole kernel on one side of its middle add up to, the middle itself
// left out. Sums of positive numbers only: where a kernel is much wider than the image, the difference of two of its
// totals would have no digits left.
float SATWholeSide(int order, int widthTexels, int texels)
{
    float w = widthTexels;
    float n = min(texels, order * (widthTexels - 1) / 2);
    if (order == 1)
        return n;
    if (order == 2)
        return n * w - 0.5 * n * (n + 1.0);
    float inner = min(n, 0.5 * (w - 1.0));
    float sum = inner * (0.75 * w * w + 0.25) - inner * (inner + 1.0) * (2.0 * inner + 1.0) / 6.0;
    float outer = 1.5 * (w - 1.0) - inner;  // weights outside of the inner ones: r (r + 1) / 2, r falling to 1
    float rest = 1.5 * (w - 1.0) - n;
    return sum + (outer * (outer + 1.0) * (outer + 2.0) - rest * (rest + 1.0) * (rest + 2.0)) / 6.0;
}

// SATMassWhole: what the weights of SATSumWhole add up to inside the image, on one axis. `texel` is inside.
float SATMassWhole(int order, int texel, int widthTexels, int sizeTexels)
{
    float w = widthTexels;
    float middle = order == 1 ? 1.0 : order == 2 ? w : 0.75 * w * w + 0.25;
    return middle + SATWholeSide(order, widthTexels, texel) + SATWholeSide(order, widthTexels, sizeTexels - 1 - texel);
}

// SATKernelSide: the integral of the kernel of order n, of boxes of width 1 about 0, from 0 to t.
float SATKernelSide(int order, float t)
{
    float u = abs(t);
    float side;
    if (order == 1)
        side = min(u, 0.5);
    else if (order == 2)
        side = u < 1.0 ? u - 0.5 * u * u : 0.5;
    else if (u < 0.5)
        side = u * (0.75 - u * u / 3.0);
    else
        side = u < 1.5 ? 0.5 - (1.5 - u) * (1.5 - u) * (1.5 - u) / 6.0 : 0.5;
    return t < 0.0 ? -side : side;
}

// SATMassOrder: what the kernel of SATSumOrder adds up to inside the image, on one axis; order 1 to 3. Without
// cancellation where the centre is inside.
float SATMassOrder(int order, float centreTexels, float widthTexels, int sizeTexels)
{
    return SATMassFull(order, widthTexels) * (SATKernelSide(order, (sizeTexels - centreTexels) / widthTexels)
                                            + SATKernelSide(order, centreTexels / widthTexels));
}

// The entries of an axis that a kernel of order n reads, and what each counts: at its n + 1 knots, n + 1 entries each,
// weighted by the B-spline of degree n.
struct SATKnots
{
    int order;
    int base;        // an entry next to the kernel's middle: all others are taken relative to it
    float centre;    // of the kernel, in texels from `origin`
    int origin;      // a whole texel near it: small numbers keep their digits
    float width;
};

SATKnots SATKnotsOf(int order, float centreTexels, float widthTexels)
{
    SATKnots k;
    k.order = order;
    k.origin = int(floor(centreTexels));
    k.centre = centreTexels - k.origin;
    k.width = widthTexels;
    // The knot at the middle of a tent, and the one left of the middle of a parabolic filter.
    k.base = k.origin + int(floor(k.centre - (order == 2 ? 0.0 : 0.5 * widthTexels))) - 1;
    return k;
}

// One of them.
struct SATKnot
{
    int entry;
    float weight;
    int3 fromBase;  // what the base's entries make of it when they are continued (SATContinue)
};

// SATKnotOf: number t of an axis: the base's entries for 0 <= t < order, then the (order + 1)^2 that are weighted.
SATKnot SATKnotOf(SATKnots k, int t)
{
    int knot = (t - k.order) / (k.order + 1);
    int i = t - k.order - knot * (k.order + 1);
    float at = k.centre + (0.5 * k.order - knot) * k.width;
    float f = at - floor(at);
    float g = 1.0 - f;
    float4 spline = k.order == 2
        ? float4(0.5 * g * g, 0.5 + f * g, 0.5 * f * f, 0.0)
        : float4(g * g * g / 6.0, (3.0 * f * f * f - 6.0 * f * f + 4.0) / 6.0,
                 (3.0 * g * g * g - 6.0 * g * g + 4.0) / 6.0, f * f * f / 6.0);
    bool isBase = t < k.order;
    SATKnot r;
    r.entry = isBase ? k.base - t : k.origin + int(floor(at)) - k.order + i;
    r.weight = isBase ? 0.0 : spline[max(i, 0)] * SATBinomial(k.order, knot);
    r.fromBase = SATContinue(k.order, r.entry - k.base);
    return r;
}

// SATSumOrder: the sum of codes under a tent or a parabolic filter of any width about any point.
//
//   table         of order n, of integers
//   extentTexels  (W, H)
//   order         2, 3
//   centreTexels  in edge coordinates
//   sizeTexels    of the boxes that the kernel is made of; 1 at least
//   returns       the integral of the image times the kernel times (w h)^n; the image is 0 outside
//
// A wrapped entry cannot be weighted. So the table is first made to start at the kernel's middle: what the entries there
// continue as is taken off every other, in integers. What is left are sums from the middle outwards, positive and
// negative: SATAxisMass bounds them.
//
// Range:  exact sums while SATBoxIsExact; else it is wrong.
// Error:  1e-5 of the largest code's filtered value (SATOrder.TentAndParabolicAreTheAnalyticFilter).
// Cost:   121 loads a word (order 2), 361 (order 3); more at the right and bottom rim (SATLoadOrder).
float4 SATSumOrder(SATExactTable table, int2 extentTexels, int order, float2 centreTexels, float2 sizeTexels)
{
    SATKnots kx = SATKnotsOf(order, centreTexels.x, sizeTexels.x);
    SATKnots ky = SATKnotsOf(order, centreTexels.y, sizeTexels.y);
    int last = order + (order + 1) * (order + 1);

    // Columns and rows 0 .. order - 1 are those at the base, the others the kernel's. Of each row its entries at the base
    // are kept, and of the rows at the base all that the kernel reads. Loops stay loops: drivers are slow to compile
    // hundreds of copies.
    SATWide baseRows[48];
    SATWide baseColumn[3];
    float4 sum = (float4)0;
    [loop]
    for (int y = 0; y < last; y++)
    {
        SATKnot row = SATKnotOf(ky, y);
        float4 rowSum = (float4)0;
        [loop]
        for (int x = 0; x < last; x++)
        {
            SATKnot column = SATKnotOf(kx, x);
            SATWide entry = SATLoadOrder(table, extentTexels, order, int2(column.entry, row.entry));
            if (x < order)
            {
                baseColumn[x] = entry;
            }
            else
            {
                int first = order * (x - order);
                [unroll(3)]
                for (int i = 0; i < order; i++)
                    entry = SATWideSub(entry, SATWideScale(baseColumn[i], column.fromBase[i]));
                if (y < order)
                {
                    baseRows[first + y] = entry;
                }
                else
                {
                    [unroll(3)]
                    for (int j = 0; j < order; j++)
                        entry = SATWideSub(entry, SATWideScale(baseRows[first + j], row.fromBase[j]));
                    rowSum += column.weight * SATWideToFloat(entry, table.words, true);
                }
            }
        }
        sum += row.weight * rowSum;
    }
    return sum;
}

#endif
