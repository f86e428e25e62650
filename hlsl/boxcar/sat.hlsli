// sat.hlsli: reading a summed-area table.
//
// The table of a W x H image holds T(i, j) = the sum of texels (0..i, 0..j), both ends included, origin top-left.
// Its integral form is F(x, y) = the integral of the image over [0, x) x [0, y) in edge coordinates (texel.hlsli), so
// F(i, j) = T(i - 1, j - 1) at whole corners, 0 on the left and the top edge, and bilinear in between: lookups at
// fractional corners are exact, not an approximation.
//
//   SATClipBox     box round a point -> its part inside the image
//   SATBoxArea     the area of that part
//   SATSumBox      the sum of the image over it: 16 loads
//   SATSampleBox, SATSampleBoxZero    the mean, by uv
//
// Crow 1984, sect. 2.1; Hensley 2005, sect. 2
#ifndef BOXCAR_SAT_HLSLI
#define BOXCAR_SAT_HLSLI

#include "boxcar/texel.hlsli"

// A box in edge coordinates, [lo, hi) on both axes, inside the image. Empty boxes have lo = hi on an axis.
struct SATBox
{
    float2 loTexels;
    float2 hiTexels;
};

// SATClipBox: the part of a box that lies inside the image.
//
//   extentTexels  (W, H)
//   centreTexels  centre, in edge coordinates
//   sizeTexels    full width and height; less than 1 is taken as 1
SATBox SATClipBox(int2 extentTexels, float2 centreTexels, float2 sizeTexels)
{
    float2 radiusTexels = 0.5 * max(sizeTexels, 1.0);
    SATBox box;
    box.loTexels = clamp(centreTexels - radiusTexels, 0.0, float2(extentTexels));
    box.hiTexels = clamp(centreTexels + radiusTexels, 0.0, float2(extentTexels));
    return box;
}

// SATBoxArea: area of a box, in texels.
float SATBoxArea(SATBox box)
{
    float2 sizeTexels = box.hiTexels - box.loTexels;
    return sizeTexels.x * sizeTexels.y;
}

// SATLoadCorner: F at a whole corner, 0 <= corner <= extent. The address is clamped and the left and top edge are put
// to 0 by hand, because no sampler's address mode gives 0 on two sides and the last entry on the other two.
float4 SATLoadCorner(Texture2D<float4> table, int2 extentTexels, int2 corner)
{
    float4 value = table.Load(int3(clamp(corner - 1, 0, extentTexels - 1), 0));
    return (corner.x > 0 && corner.y > 0) ? value : (float4)0;
}

// SATSumStrip: the sum over columns [loX, hiX) of rows [0, y), fractional in x, whole in y.
float4 SATSumStrip(Texture2D<float4> table, int2 extentTexels, float loX, float hiX, int y)
{
    int lo = int(floor(loX));
    int hi = int(floor(hiX));
    float4 atLo = SATLoadCorner(table, extentTexels, int2(lo, y));
    float4 atHi = SATLoadCorner(table, extentTexels, int2(hi, y));
    float4 columnLo = SATLoadCorner(table, extentTexels, int2(lo + 1, y)) - atLo;
    float4 columnHi = SATLoadCorner(table, extentTexels, int2(hi + 1, y)) - atHi;
    return (atHi - atLo) + (hiX - hi) * columnHi - (loX - lo) * columnLo;
}

// SATSumBox: the sum of the source image over a box, weighted by coverage where an edge cuts a texel.
//
//   table         W x H inclusive table of the source, float32
//   extentTexels  (W, H)
//   box           from SATClipBox: inside the image
//   returns       sum per channel, in the source's units x texels
//
// Error:  at most (4 d + 20) u S, where u = 2^-24, d = ceil(log2 W) + ceil(log2 H) is the depth of the tree by which
//         sat_build.hlsli adds, and S the sum of the magnitudes of all texels: 4 d for the table's entries at four
//         corners, 20 for this lookup (BoxFilter.IsWithinTheDocumentedBoundOfTheDefinition). 0 where S < 2^24 and both
//         the texels and the box's edges are whole numbers.
// Cost:   16 loads, no dependent reads.
//
// Crow 1984, sect. 2.1; Hensley 2005, sect. 2 (Fig. 2)
float4 SATSumBox(Texture2D<float4> table, int2 extentTexels, SATBox box)
{
    float2 lo = box.loTexels;
    float2 hi = box.hiTexels;
    int top = int(floor(lo.y));
    int bottom = int(floor(hi.y));

    // Differences along x first: they cancel between entries of like size, before anything is rounded away.
    float4 atTop = SATSumStrip(table, extentTexels, lo.x, hi.x, top);
    float4 atBottom = SATSumStrip(table, extentTexels, lo.x, hi.x, bottom);
    float4 rowTop = SATSumStrip(table, extentTexels, lo.x, hi.x, top + 1) - atTop;
    float4 rowBottom = SATSumStrip(table, extentTexels, lo.x, hi.x, bottom + 1) - atBottom;
    return (atBottom - atTop) + (hi.y - bottom) * rowBottom - (lo.y - top) * rowTop;
}

// SATSampleBox: mean of the source image over an axis-aligned box, at a cost that does not depend on its size.
// The paper's tex2D_SAT_blur, in texel units and without its half-texel shift.
//
//   table         W x H inclusive table of the source, float32
//   extentTexels  (W, H)
//   uv            box centre; [0, 1] across the image, origin top-left, texel centres at (i + 0.5) / W
//   sizeTexels    full width and height of the box; less than 1 is taken as 1
//   returns       mean per channel, in the source's units; 0 where the box misses the image
//
// Border:  the box is clipped to the image and divided by the area that is left, so a constant image stays constant up
//          to its rim. No sampler and no border colour take part.
// Limits:  sizeTexels = 1 is the source, bilinearly filtered; sizeTexels >= 2 * extent is the mean of it all.
// Error:   that of SATSumBox, divided by the area.
// Cost:    16 loads, no dependent reads.
//
// Crow 1984, sect. 2.1 (the identity); Hensley 2005, sect. 2 and 4 (bits, bias); Scheuermann 2005 (tex2D_SAT_blur)
float4 SATSampleBox(Texture2D<float4> table, int2 extentTexels, float2 uv, float2 sizeTexels)
{
    SATBox box = SATClipBox(extentTexels, TexelUvToEdge(uv, extentTexels), sizeTexels);
    float areaTexels = SATBoxArea(box);
    return areaTexels > 0.0 ? SATSumBox(table, extentTexels, box) / areaTexels : (float4)0;
}

// SATSampleBoxZero: as SATSampleBox, but the image is 0 outside and the whole box divides: coverage fades at the rim.
//
// Crow 1984 (where truncated coordinates meet an untruncated area)
float4 SATSampleBoxZero(Texture2D<float4> table, int2 extentTexels, float2 uv, float2 sizeTexels)
{
    float2 wholeTexels = max(sizeTexels, 1.0);
    SATBox box = SATClipBox(extentTexels, TexelUvToEdge(uv, extentTexels), wholeTexels);
    return SATSumBox(table, extentTexels, box) / (wholeTexels.x * wholeTexels.y);
}

#endif
