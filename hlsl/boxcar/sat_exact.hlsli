// sat_exact.hlsli: summed-area tables of integers, whose boxes are exact.
//
// The table's entries are sums of whole-number codes modulo 2^32 (one word a channel) or 2^64 (two words, in two
// textures). They wrap around, and differences of them undo the wrap: a sum that fits into the words comes out right to
// the last bit, in a table of any size (sat_range.h says how large it may be). So differences come first, in integers,
// and weights last, in floats; wrapped entries are never interpolated.
//
//   SATWide..        four integers modulo 2^64, one a channel; with one word only .low counts
//   SATLoadCorner    F at any whole corner (sat.hlsli says what F is)
//   SATSumTexels     the sum over whole texels: 4 loads a word
//   SATSumBox        the sum over any box, rounded to float: 16 loads a word
//   SATCutBoxOf, SATSumCutBox, SATCutArea    the same in pairs of floats, of a box whose place is told apart from its size
//   SATDiscEdges     one of the boxes that make a disc or a polygon, as pairs
//
// Hensley 2005, sect. 4 (the bits that a table needs); beyond the papers
#ifndef BOXCAR_SAT_EXACT_HLSLI
#define BOXCAR_SAT_EXACT_HLSLI

#include "boxcar/float_pair.hlsli"
#include "boxcar/sat.hlsli"
#include "boxcar/sat_range.h"

// A table of integers, W x H. With one word, `high` is not read: name the same texture twice.
struct SATExactTable
{
    Texture2D<uint4> low;
    Texture2D<uint4> high;
    int words;      // 1 or 2
    bool isSigned;  // codes may be negative: sums are read as two's complement
};

SATExactTable SATTable32(Texture2D<uint4> table)
{
    SATExactTable t;
    t.low = table;
    t.high = table;
    t.words = 1;
    t.isSigned = false;
    return t;
}

SATExactTable SATTable64(Texture2D<uint4> low, Texture2D<uint4> high, bool isSigned)
{
    SATExactTable t;
    t.low = low;
    t.high = high;
    t.words = 2;
    t.isSigned = isSigned;
    return t;
}

struct SATWide
{
    uint4 low;
    uint4 high;
};

SATWide SATWideOf(uint4 low, uint4 high)
{
    SATWide r;
    r.low = low;
    r.high = high;
    return r;
}

SATWide SATWideAdd(SATWide a, SATWide b)
{
    uint4 low = a.low + b.low;
    return SATWideOf(low, a.high + b.high + uint4(low < a.low));
}

SATWide SATWideSub(SATWide a, SATWide b)
{
    return SATWideOf(a.low - b.low, a.high - b.high - uint4(a.low < b.low));
}

// SATMulHigh: the upper word of a product. Shader model 5 has no instruction for it.
uint4 SATMulHigh(uint4 a, uint b)
{
    uint4 aLow = a & 0xffffu, aHigh = a >> 16;
    uint bLow = b & 0xffffu, bHigh = b >> 16;
    uint4 middle = aHigh * bLow + ((aLow * bLow) >> 16);  // at most (2^16 - 1) 2^16: it fits
    uint4 other = aLow * bHigh + (middle & 0xffffu);
    return aHigh * bHigh + (middle >> 16) + (other >> 16);
}

SATWide SATWideScale(SATWide a, int factor)
{
    uint low = uint(factor);
    uint4 high = SATMulHigh(a.low, low) + a.high * low;
    return SATWideOf(a.low * low, factor < 0 ? high - a.low : high);
}

// SATWideToFloat: to the nearest float for one word; off by 2 u of it for two.
//
//   isSigned  two's complement
float4 SATWideToFloat(SATWide a, int words, bool isSigned)
{
    if (words == 1)
        return isSigned ? float4(int4(a.low)) : float4(a.low);
    bool4 isNegative = int4(a.high) < 0;
    uint4 negative = isSigned ? uint4(isNegative) : uint4(0u, 0u, 0u, 0u);
    SATWide flipped = SATWideOf(a.low ^ (0u - negative), a.high ^ (0u - negative));
    SATWide magnitude = SATWideAdd(flipped, SATWideOf(negative, uint4(0u, 0u, 0u, 0u)));
    return (1.0 - 2.0 * float4(negative)) * (4294967296.0 * float4(magnitude.high) + float4(magnitude.low));
}

// SATWideToPair: exact below 2^48, else rounded to 48 bits.
//
//   isSigned  two's complement
FloatPair SATWideToPair(SATWide a, int words, bool isSigned)
{
    bool4 isNegative = int4(words == 1 ? a.low : a.high) < 0;
    uint4 negative = isSigned ? uint4(isNegative) : uint4(0u, 0u, 0u, 0u);
    SATWide flipped = SATWideOf(a.low ^ (0u - negative), a.high ^ (0u - negative));
    SATWide magnitude = SATWideAdd(flipped, SATWideOf(negative, uint4(0u, 0u, 0u, 0u)));
    float4 sign = 1.0 - 2.0 * float4(negative);
    FloatPair pair = FloatPairOrdered(sign * 65536.0 * float4(magnitude.low >> 16),
                                      sign * float4(magnitude.low & 0xffffu));
    if (words == 2)
        pair = FloatPairAdd(FloatPairOrdered(sign * 281474976710656.0 * float4(magnitude.high >> 16),
                                             sign * 4294967296.0 * float4(magnitude.high & 0xffffu)), pair);
    return pair;
}

// SATWideFromFloat: the nearest whole number; 0 <= value < 2^64. With one word: below 2^32.
//
// Error: none beyond rounding: floats over 2^24 are whole numbers already.
SATWide SATWideFromFloat(float4 value)
{
    float4 whole = floor(value + 0.5);
    float4 high = floor(whole / 4294967296.0);
    return SATWideOf(uint4(whole - high * 4294967296.0), uint4(high));
}

// SATLoadEntry: a table's entry; 0 left of and above the image. 'texel' is clamped to it on the right and below.
SATWide SATLoadEntry(SATExactTable table, int2 extentTexels, int2 texel)
{
    int3 at = int3(clamp(texel, 0, extentTexels - 1), 0);
    uint inside = (texel.x >= 0 && texel.y >= 0) ? 1u : 0u;
    SATWide entry = SATWideOf(inside * table.low.Load(at), uint4(0u, 0u, 0u, 0u));
    if (table.words == 2)
        entry.high = inside * table.high.Load(at);
    return entry;
}

// SATLoadCorner: F at any whole corner, of a table whose origin is (0, 0).
//
// Cost: 1 load a word; 4 where the image is repeated and the corner lies outside.
SATWide SATLoadCorner(SATExactTable table, SATFrame frame, int2 corner)
{
    SATPlace x = SATPlaceOf(corner.x, frame.extentTexels.x, frame.edge);
    SATPlace y = SATPlaceOf(corner.y, frame.extentTexels.y, frame.edge);
    int2 size = frame.extentTexels;
    SATWide value = SATLoadEntry(table, size, int2(x.inside, y.inside) - 1);
    if (!x.isInside || !y.isInside)
    {
        SATWide right = SATLoadEntry(table, size, int2(size.x, y.inside) - 1);
        SATWide below = SATLoadEntry(table, size, int2(x.inside, size.y) - 1);
        SATWide whole = SATLoadEntry(table, size, size - 1);
        SATWide atY = SATWideAdd(SATWideScale(value, x.sign), SATWideScale(right, x.wholes));
        SATWide atEnd = SATWideAdd(SATWideScale(below, x.sign), SATWideScale(whole, x.wholes));
        value = SATWideAdd(SATWideScale(atY, y.sign), SATWideScale(atEnd, y.wholes));
    }
    return value;
}

// SATSumTexels: the sum of the codes over whole texels, lo <= texel < hi.
//
//   returns  modulo 2^32 or 2^64: exact while the sum itself fits (SATBoxIsExact)
//
// Cost: 4 loads a word; 16 where the image is repeated and the box lies outside.
//
// Crow 1984, sect. 2.1; Hensley 2005, sect. 2 (Fig. 2)
SATWide SATSumTexels(SATExactTable table, SATFrame frame, int2 lo, int2 hi)
{
    SATWide below = SATWideSub(SATLoadCorner(table, frame, hi), SATLoadCorner(table, frame, int2(lo.x, hi.y)));
    SATWide above = SATWideSub(SATLoadCorner(table, frame, int2(hi.x, lo.y)), SATLoadCorner(table, frame, lo));
    return SATWideSub(below, above);
}

// The three stretches that a box takes from an axis: part of a texel, whole texels, part of a texel.
struct SATStretches
{
    int4 corner;       // where they begin and end
    FloatPair weight;  // how much of each counts, in x, y and z; exact: 1 - 0.1 takes more than a float
};

// SATStretchesFrom: from a part of the texel `first` to a part of `last`; or of a part of one. `before` and `after` are how
// much of the two lies inside.
SATStretches SATStretchesFrom(int first, FloatPair before, int last, FloatPair after)
{
    bool isOneTexel = last <= first;
    SATStretches s;
    s.corner = int4(first, first + 1, isOneTexel ? first + 1 : last, last + 1);
    FloatPair part = before;
    if (isOneTexel)
        part = FloatPairAdd(FloatPairAdd(before, after), FloatPairSplat(-1.0));
    float2 others = isOneTexel ? float2(0.0, 0.0) : float2(1.0, after.high.x);
    s.weight = FloatPairOf(float4(part.high.x, others, 0.0), float4(part.low.x, 0.0, others.x * after.low.x, 0.0));
    return s;
}

// SATStretchesOf: of [lo, hi), in edge coordinates.
SATStretches SATStretchesOf(float lo, float hi)
{
    int first = int(floor(lo));
    int last = int(floor(hi));
    bool isOneTexel = last <= first;
    SATStretches s;
    s.corner = int4(first, first + 1, isOneTexel ? first + 1 : last, last + 1);
    float4 begin = isOneTexel ? float4(lo, 0.0, 0.0, 0.0) : float4(lo, 0.0, last, 0.0);
    float4 end = isOneTexel ? float4(hi, 0.0, 0.0, 0.0) : float4(first + 1, 1.0, hi, 0.0);
    s.weight = FloatPairSum(end, -begin);
    return s;
}

// A box cut into stretches of either axis.
struct SATCutBox
{
    SATStretches x;
    SATStretches y;
};

// SATCutBoxOf: the part of a box that lies inside the image; all of it where the image goes on (REPEAT, MIRROR).
//
//   baseTexels  where the edges are counted from: a texel near the box, so that they keep their digits far from the
//               image's corner
//   edges       left, top, right, bottom, in edge coordinates from there
SATCutBox SATCutBoxOf(SATFrame frame, int2 baseTexels, FloatPair edges)
{
    float4 whole = floor(edges.high);
    whole -= float4(edges.high == whole) * float4(edges.low < 0.0);
    // How much of the texel that an edge cuts lies left of or above it, and right of or below it.
    FloatPair after = FloatPairSum(edges.high - whole, edges.low);
    FloatPair before = FloatPairSum((whole + 1.0) - edges.high, -edges.low);
    int4 corner = baseTexels.xyxy + int4(whole);
    if (frame.edge < SAT_EDGE_REPEAT)
    {
        int4 inside = clamp(corner, 0, frame.extentTexels.xyxy);
        float4 isInside = float4(inside == corner) * float4(corner < frame.extentTexels.xyxy);
        after = FloatPairOf(isInside * after.high, isInside * after.low);
        before = FloatPairOf(max(isInside * before.high, 1.0 - isInside), isInside * before.low);
        corner = inside;
    }
    SATCutBox cut;
    cut.x = SATStretchesFrom(corner.x, FloatPairLane(before, 0), corner.z, FloatPairLane(after, 2));
    cut.y = SATStretchesFrom(corner.y, FloatPairLane(before, 1), corner.w, FloatPairLane(after, 3));
    return cut;
}

// SATStretchesLength: how many texels they are, in every lane.
FloatPair SATStretchesLength(SATStretches s)
{
    float whole = s.weight.high.y * float(s.corner.z - s.corner.y);
    FloatPair parts = FloatPairAdd(FloatPairLane(s.weight, 0), FloatPairLane(s.weight, 2));
    return FloatPairAdd(parts, FloatPairSplat(whole));
}

// SATEdgesArea: the area of a box that is not cut, in texels, in every lane.
FloatPair SATEdgesArea(FloatPair edges)
{
    FloatPair size = FloatPairSub(FloatPairOf(edges.high.zwzw, edges.low.zwzw), FloatPairOf(edges.high.xyxy, edges.low.xyxy));
    return FloatPairMul(FloatPairOf(size.high.xxxx, size.low.xxxx), FloatPairOf(size.high.yyyy, size.low.yyyy));
}

// SATCutArea: the area of a cut box, in texels, in every lane.
FloatPair SATCutArea(SATCutBox cut)
{
    return FloatPairMul(SATStretchesLength(cut.x), SATStretchesLength(cut.y));
}

// SATSumCutBox: the sum of the codes over a box, weighted by coverage where an edge cuts a texel.
//
//   table    the integers' table, origin (0, 0)
//   frame    how it lies over the image
//   returns  sum per channel, in codes x texels
//
// Range:  as long as the whole texels' sum fits into the words (SATBoxIsExact); else it is wrong.
// Error:  some 2^-43 of the sum of magnitudes: nothing beside the rounding of a mean to float
//         (ExactFilter.MeansAreRightToTheLastBit). 0 with whole edges and sums below 2^48.
// Cost:   16 loads a word; 64 where the image is repeated and the box lies outside.
FloatPair SATSumCutBox(SATExactTable table, SATFrame frame, SATCutBox cut)
{
    SATWide zero = SATWideOf(uint4(0u, 0u, 0u, 0u), uint4(0u, 0u, 0u, 0u));
    SATWide above[4] = { zero, zero, zero, zero };
    FloatPair sum = FloatPairSplat(0.0);
    // Loops that stay loops: drivers are slow to compile sixteen copies of a corner.
    [loop]
    for (int row = 0; row < 4; row++)
    {
        SATWide left = zero;
        FloatPair rowSum = FloatPairSplat(0.0);
        [loop]
        for (int column = 0; column < 4; column++)
        {
            SATWide corner = SATLoadCorner(table, frame, int2(cut.x.corner[column], cut.y.corner[row]));
            SATWide strip = SATWideSub(corner, left);  // of column - 1
            if (row > 0 && column > 0)
            {
                FloatPair part = SATWideToPair(SATWideSub(strip, above[column]), table.words, table.isSigned);
                rowSum = FloatPairAdd(rowSum, FloatPairMul(FloatPairLane(cut.x.weight, column - 1), part));
            }
            above[column] = strip;
            left = corner;
        }
        if (row > 0)
            sum = FloatPairAdd(sum, FloatPairMul(rowSum, FloatPairLane(cut.y.weight, row - 1)));
    }
    return sum;
}

// SATSumBox: SATSumCutBox of a box in plain edge coordinates, rounded to float.
//
//   box  from SATClipBox
//
// Error:  of the box's own edges, which are floats; beyond that u of the sum.
float4 SATSumBox(SATExactTable table, SATFrame frame, SATBox box)
{
    FloatPair edges = FloatPairOf(float4(box.loTexels, box.hiTexels), (float4)0);
    return FloatPairToFloat(SATSumCutBox(table, frame, SATCutBoxOf(frame, int2(0, 0), edges)));
}

// SATDiscEdges: the edges of one of the boxes of SATDiscBox: left, top, right, bottom, in texels from the disc's center.
//
// Error:  2^-43 of them; of a polygon's left and right edges that of SATPolygonHalfWidth.
FloatPair SATDiscEdges(float2 diameterTexels, int sides, int boxes, int index)
{
    float middle = 2.0 * index + 1.0 - boxes;  // of its height; -boxes is the top of the disc
    FloatPair side;
    if (sides == 0)
        side = FloatPairSqrt((float4)(float(boxes) * boxes - middle * middle));
    else
        side = FloatPairSplat(boxes * SATPolygonHalfWidth(sides, middle / boxes));
    FloatPair edges = FloatPairOf(float4(-side.high.x, middle - 1.0, side.high.x, middle + 1.0),
                                  float4(-side.low.x, 0.0, side.low.x, 0.0));
    FloatPair scaled = FloatPairMul(edges, FloatPairOf(diameterTexels.xyxy, (float4)0));
    return FloatPairDiv(scaled, FloatPairSplat(2.0 * boxes));
}

#endif
