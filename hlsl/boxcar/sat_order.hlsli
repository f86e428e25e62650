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
//   SATSumOrder      any W about any point, n = 2, 3: 121 and 361 loads a word; to 40 bits (float_pair.hlsli)
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
// that is what a table would hold if nothing lay before. |ahead| <= 46339, so that the weights fit.
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
FloatPair SATMassFull(int order, float widthTexels)
{
    FloatPair width = FloatPairSplat(widthTexels);
    FloatPair mass = width;
    for (int n = 1; n < order; n++)
        mass = FloatPairMul(mass, width);
    return mass;
}

// SATTetrahedral: r (r + 1) (r + 2) / 6, the sum of the first r triangular numbers.
FloatPair SATTetrahedral(float r)
{
    FloatPair product = FloatPairMul(FloatPairProduct((float4)r, (float4)(r + 1.0)), FloatPairSplat(r + 2.0));
    return FloatPairDiv(product, FloatPairSplat(6.0));
}

// SATWholeSide: what the first `texels` weights of a whole kernel on one side of its middle add up to, the middle itself
// left out. Sums of positive numbers only: where a kernel is much wider than the image, the difference of two of its
// totals would have no digits left.
FloatPair SATWholeSide(int order, int widthTexels, int texels)
{
    float w = widthTexels;
    float n = min(texels, order * (widthTexels - 1) / 2);
    if (order == 1)
        return FloatPairSplat(n);
    if (order == 2)
        return FloatPairProduct((float4)(0.5 * n), (float4)(2.0 * w - n - 1.0));
    // Weights 3/4 w^2 + 1/4 - i^2 up to (w - 1) / 2 from the middle; r (r + 1) / 2 beyond it, r falling to 1.
    float inner = min(n, 0.5 * (w - 1.0));
    float outer = 1.5 * (w - 1.0) - inner;
    float rest = 1.5 * (w - 1.0) - n;
    FloatPair peak = FloatPairAdd(FloatPairProduct((float4)(0.75 * w), (float4)w), FloatPairSplat(0.25));
    FloatPair squares = FloatPairMul(FloatPairProduct((float4)inner, (float4)(inner + 1.0)), FloatPairSplat(2.0 * inner + 1.0));
    FloatPair sum = FloatPairSub(FloatPairMul(FloatPairSplat(inner), peak), FloatPairDiv(squares, FloatPairSplat(6.0)));
    return FloatPairAdd(sum, FloatPairSub(SATTetrahedral(outer), SATTetrahedral(rest)));
}

// SATMassWhole: what the weights of SATSumWhole add up to inside the image, on one axis. `texel` is inside.
FloatPair SATMassWhole(int order, int texel, int widthTexels, int sizeTexels)
{
    float w = widthTexels;
    FloatPair middle = FloatPairSplat(order == 1 ? 1.0 : w);
    if (order == 3)
        middle = FloatPairAdd(FloatPairProduct((float4)(0.75 * w), (float4)w), FloatPairSplat(0.25));
    return FloatPairAdd(middle, FloatPairAdd(SATWholeSide(order, widthTexels, texel),
                                             SATWholeSide(order, widthTexels, sizeTexels - 1 - texel)));
}

// SATKernelSide: the integral of the kernel of order n, of boxes of width 1 about 0, from 0 to t, t not negative.
FloatPair SATKernelSide(int order, FloatPair t)
{
    float u = t.high.x;
    FloatPair half = FloatPairSplat(0.5);
    if (u >= 0.5 * order)
        return half;
    FloatPair square = FloatPairMul(t, t);
    if (order == 1)
        return t;
    if (order == 2)
        return FloatPairSub(t, FloatPairMul(half, square));
    if (u < 0.5)
        return FloatPairMul(t, FloatPairSub(FloatPairSplat(0.75), FloatPairDiv(square, FloatPairSplat(3.0))));
    FloatPair rest = FloatPairSub(FloatPairSplat(1.5), t);
    FloatPair cube = FloatPairMul(FloatPairMul(rest, rest), rest);
    return FloatPairSub(half, FloatPairDiv(cube, FloatPairSplat(6.0)));
}

// SATMassOrder: what the kernel of SATSumOrder adds up to inside the image, on one axis; order 1 to 3. Without
// cancellation.
//
//   beforeTexels, afterTexels  from the kernel's centre to either end of the image; not negative
FloatPair SATMassOrder(int order, float widthTexels, float beforeTexels, float afterTexels)
{
    FloatPair width = FloatPairSplat(widthTexels);
    FloatPair before = SATKernelSide(order, FloatPairDiv(FloatPairSplat(beforeTexels), width));
    FloatPair after = SATKernelSide(order, FloatPairDiv(FloatPairSplat(afterTexels), width));
    return FloatPairMul(SATMassFull(order, widthTexels), FloatPairAdd(before, after));
}

// One of the n + 1 knots of a kernel of order n on an axis, and the n + 1 entries there that it reads, weighted by the
// B-spline of degree n.
struct SATKnot
{
    int entry;         // the first of them
    FloatPair weight;  // of each, one a lane
};

// SATWholeKnotOf: the same of a whole kernel about the texel `baseTexels`, which reads one entry at each knot (SATSumWhole).
SATKnot SATWholeKnotOf(int order, int index, int baseTexels, int widthTexels)
{
    SATKnot knot;
    knot.entry = baseTexels + order * (widthTexels - 1) / 2 - index * widthTexels;
    knot.weight = FloatPairOf(float4(SATBinomial(order, index), 0.0, 0.0, 0.0), (float4)0);
    return knot;
}

// SATKnotOf: knot number `index`, from the right.
//
//   centreTexels  of the kernel, from `baseTexels`
SATKnot SATKnotOf(int order, int index, int baseTexels, float centreTexels, float widthTexels)
{
    float side = 0.5 * order - index;
    FloatPair at = FloatPairAdd(FloatPairSplat(centreTexels), FloatPairProduct((float4)side, (float4)widthTexels));
    float whole = floor(at.high.x);
    if (at.high.x == whole && at.low.x < 0.0)
        whole -= 1.0;
    FloatPair f = FloatPairAdd(FloatPairSplat(-whole), at);
    FloatPair g = FloatPairSub(FloatPairSplat(1.0), f);
    FloatPair sign = FloatPairSplat(SATBinomial(order, index));
    SATKnot knot;
    knot.entry = baseTexels + int(whole) - order;
    // g^2 / 2, 1/2 + f g, f^2 / 2
    FloatPair left = FloatPairOf(float4(g.high.x, f.high.x, f.high.x, 0.0), float4(g.low.x, f.low.x, f.low.x, 0.0));
    FloatPair right = FloatPairOf(float4(g.high.x, g.high.x, f.high.x, 0.0), float4(g.low.x, g.low.x, f.low.x, 0.0));
    float4 share = float4(0.5, 1.0, 0.5, 0.0);
    if (order == 3)
    {
        // g^3 / 6, (3 f^3 - 6 f^2 + 4) / 6, (3 g^3 - 6 g^2 + 4) / 6, f^3 / 6
        FloatPair x = FloatPairOf(float4(g.high.x, f.high.x, g.high.x, f.high.x), float4(g.low.x, f.low.x, g.low.x, f.low.x));
        left = FloatPairMul(x, x);
        right = FloatPairSub(FloatPairMul(FloatPairOf(float4(1.0, 3.0, 3.0, 1.0), (float4)0), x),
                             FloatPairOf(float4(0.0, 6.0, 6.0, 0.0), (float4)0));
        share = (float4)1;
    }
    FloatPair product = FloatPairMul(FloatPairMul(left, right), FloatPairOf(share, (float4)0));
    float4 constant = order == 2 ? float4(0.0, 0.5, 0.0, 0.0) : float4(0.0, 4.0, 4.0, 0.0);
    FloatPair weight = FloatPairAdd(product, FloatPairOf(constant, (float4)0));
    if (order == 3)
        weight = FloatPairDiv(weight, FloatPairSplat(6.0));
    knot.weight = FloatPairMul(sign, weight);
    return knot;
}

// SATMiddleEntry: an entry next to a kernel's middle: the knot there of a tent, the one left of it of a parabolic filter.
int SATMiddleEntry(int order, int baseTexels, float centreTexels, float widthTexels)
{
    return baseTexels + int(floor(centreTexels - (order == 2 ? 0.0 : 0.5 * widthTexels))) - 1;
}

// SATSumOrder: the sum of codes under a tent or a parabolic filter of any width about any point.
//
//   table         of order n, of integers
//   extentTexels  (W, H)
//   order         2, 3
//   baseTexels    where the centre is counted from: a texel near it, so that it keeps its digits
//   centreTexels  in edge coordinates from there
//   sizeTexels    of the boxes that the kernel is made of; 1 at least
//   isWholeX, isWholeY  whether the kernel is whole on that axis: the box of so many texels taken n times over texels,
//                 about the texel `baseTexels`; its width as for SATSumWhole. Else it is continuous
//   returns       the integral of the image times the kernel times (w h)^n; the image is 0 outside
//
// A wrapped entry cannot be weighted. So the table is first made to start at the kernel's middle: what the entries there
// continue as is taken off every other, in integers. What is left are sums from the middle outwards, positive and
// negative: SATAxisMass bounds them.
//
// Range:  exact sums while SATBoxIsExact; else it is wrong.
// Error:  some 2^-40 of the filtered magnitudes: nothing beside the rounding of the mean to float
//         (ExactFilter.MeansAreRightToTheLastBit).
// Cost:   121 loads a word (order 2), 361 (order 3); more at the right and bottom rim (SATLoadOrder).
FloatPair SATSumOrder(SATExactTable table, int2 extentTexels, int order, int2 baseTexels, float2 centreTexels,
                      float2 sizeTexels, bool isWholeX, bool isWholeY)
{
    SATKnot columns[4], rows[4];
    [loop]
    for (int k = 0; k <= order; k++)
    {
        columns[k] = SATKnotOf(order, k, baseTexels.x, centreTexels.x, sizeTexels.x);
        rows[k] = SATKnotOf(order, k, baseTexels.y, centreTexels.y, sizeTexels.y);
        if (isWholeX)
            columns[k] = SATWholeKnotOf(order, k, baseTexels.x, int(sizeTexels.x));
        if (isWholeY)
            rows[k] = SATWholeKnotOf(order, k, baseTexels.y, int(sizeTexels.y));
    }
    int2 middle = int2(SATMiddleEntry(order, baseTexels.x, centreTexels.x, sizeTexels.x),
                       SATMiddleEntry(order, baseTexels.y, centreTexels.y, sizeTexels.y));
    int last = order + (order + 1) * (order + 1);

    // Columns and rows 0 .. order - 1 are those at the middle, the others the kernel's. Of each row its entries in the
    // middle are kept, and of the rows in the middle all that the kernel reads. Loops stay loops: drivers are slow to
    // compile hundreds of copies.
    SATWide middleRows[48];
    SATWide middleColumn[3];
    FloatPair sum = FloatPairSplat(0.0);
    [loop]
    for (int y = 0; y < last; y++)
    {
        bool isMiddleRow = y < order;
        int rowIndex = max(y - order, 0);
        int rowKnot = rowIndex / (order + 1), rowEntry = rowIndex - rowKnot * (order + 1);
        int row = isMiddleRow ? middle.y - y : rows[rowKnot].entry + rowEntry;
        int3 fromMiddleY = SATContinue(order, row - middle.y);
        FloatPair rowSum = FloatPairSplat(0.0);
        [loop]
        for (int x = 0; x < last; x++)
        {
            bool isMiddleColumn = x < order;
            int columnIndex = max(x - order, 0);
            int columnKnot = columnIndex / (order + 1), columnEntry = columnIndex - columnKnot * (order + 1);
            int column = isMiddleColumn ? middle.x - x : columns[columnKnot].entry + columnEntry;
            SATWide entry = SATLoadOrder(table, extentTexels, order, int2(column, row));
            if (isMiddleColumn)
            {
                middleColumn[x] = entry;
            }
            else
            {
                int3 fromMiddleX = SATContinue(order, column - middle.x);
                int first = order * columnIndex;
                [unroll(3)]
                for (int i = 0; i < order; i++)
                    entry = SATWideSub(entry, SATWideScale(middleColumn[i], fromMiddleX[i]));
                if (isMiddleRow)
                {
                    middleRows[first + y] = entry;
                }
                else
                {
                    [unroll(3)]
                    for (int j = 0; j < order; j++)
                        entry = SATWideSub(entry, SATWideScale(middleRows[first + j], fromMiddleY[j]));
                    FloatPair weight = FloatPairLane(columns[columnKnot].weight, columnEntry);
                    rowSum = FloatPairAdd(rowSum, FloatPairMul(weight, SATWideToPair(entry, table.words, true)));
                }
            }
        }
        if (!isMiddleRow)
        {
            sum = FloatPairAdd(sum, FloatPairMul(FloatPairLane(rows[rowKnot].weight, rowEntry), rowSum));
        }
    }
    return sum;
}

#endif
