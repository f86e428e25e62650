// sat.hlsli: reading a summed-area table of floats.
//
// The table of a W x H image holds T(i, j) = the sum of texels (0..i, 0..j), both ends included, origin top-left.
// Its integral form is F(x, y) = the integral of the image over [0, x) x [0, y) in edge coordinates (texel.hlsli), so
// F(i, j) = T(i - 1, j - 1) at whole corners, 0 on the left and the top edge, and bilinear in between: lookups at
// fractional corners are exact, not an approximation.
//
//   SATBoxAt, SATDiscBox    a box round a point; one of those that make a disc or a polygon
//   SATClipBox              its part inside the image
//   SATBoxArea              the area of that part
//   SATSumBox               the sum of the image over it: 16 loads
//   SATSampleBox, SATSampleBoxZero, SATSampleBoxRepeat    the mean, by uv
//
// sat_exact.hlsli reads tables of integers, sat_order.hlsli those of higher order.
//
// Crow 1984, sect. 2.1; Hensley 2005, sect. 2
#ifndef BOXCAR_SAT_HLSLI
#define BOXCAR_SAT_HLSLI

#include "boxcar/texel.hlsli"

// What lies outside the image: nothing, so that filters divide by what they find inside; 0; the image over and over; the
// image and its mirror image by turns (the texel at the edge comes twice).
#define SAT_EDGE_CLIP 0
#define SAT_EDGE_ZERO 1
#define SAT_EDGE_REPEAT 2
#define SAT_EDGE_MIRROR 3

// How a table lies over its image.
struct SATFrame
{
    int2 extentTexels;  // (W, H)
    int2 originTexels;  // the corner that the sums start from: (0, 0), or (W / 2, H / 2) for a table of four quadrants,
                        // each summed away from the middle; (0, H) sums upwards from the lower left
    int edge;           // SAT_EDGE_..; REPEAT and MIRROR need the origin (0, 0)
};

SATFrame SATFrameAtCorner(int2 extentTexels, int edge)
{
    SATFrame frame;
    frame.extentTexels = extentTexels;
    frame.originTexels = int2(0, 0);
    frame.edge = edge;
    return frame;
}

// A box in edge coordinates, [lo, hi) on both axes. Empty boxes have lo = hi on an axis.
struct SATBox
{
    float2 loTexels;
    float2 hiTexels;
};

// SATBoxAt: the box round a point.
//
//   centreTexels  in edge coordinates
//   sizeTexels    full width and height
SATBox SATBoxAt(float2 centreTexels, float2 sizeTexels)
{
    SATBox box;
    box.loTexels = centreTexels - 0.5 * sizeTexels;
    box.hiTexels = centreTexels + 0.5 * sizeTexels;
    return box;
}

// SATPolygonHalfWidth: half the width of a regular polygon in a circle of radius 1 about 0, a corner at the top, at the
// height y: -1 at the top, 1 at the bottom; 0 below the polygon.
float SATPolygonHalfWidth(int sides, float y)
{
    float turn = 6.28318531 / sides;
    float halfWidth = 1.0;
    [loop]
    for (int side = 0; 2 * side < sides; side++)  // from the top corner to the right and down
    {
        float2 outward = float2(sin((side + 0.5) * turn), -cos((side + 0.5) * turn));
        if (outward.x > 1e-6)
            halfWidth = min(halfWidth, (cos(0.5 * turn) - y * outward.y) / outward.x);
        else if (y * outward.y > cos(0.5 * turn))
            halfWidth = 0.0;
    }
    return max(halfWidth, 0.0);
}

// SATDiscBox: one of the boxes of equal height that stand for a disc or a polygon, from the top. Each is as wide as the
// shape is at the middle of its height. A disc of one box is the box.
//
//   centreTexels    in edge coordinates
//   diameterTexels  of the disc, or of the circle that the polygon's corners lie on; width and height may differ
//   sides           of the polygon, 3 at least; 0 for a disc
//   boxes           1 at least
//   index           0 <= index < boxes
//
// Cost: that of a box for each, and so is the error. Area: 1.3 % more than the disc's for 8 boxes, 0.5 % for 16 (SATFilter.TheBoxesOfADiscHaveAlmostItsArea).
SATBox SATDiscBox(float2 centreTexels, float2 diameterTexels, int sides, int boxes, int index)
{
    float heightTexels = diameterTexels.y / boxes;
    float middle = (2.0 * index + 1.0) / boxes - 1.0;  // -1 at the top of the disc, 1 at its bottom
    float halfWidth = sides == 0 ? sqrt(1.0 - middle * middle) : SATPolygonHalfWidth(sides, middle);
    float widthTexels = diameterTexels.x * halfWidth;
    return SATBoxAt(centreTexels + float2(0.0, 0.5 * middle * diameterTexels.y), float2(widthTexels, heightTexels));
}

// SATClipBox: the part of a box that lies inside the image. Where the image goes on (REPEAT, MIRROR) it is all of the box,
// moved by whole periods to where the image is: sums stay as small as they can be.
SATBox SATClipBox(SATFrame frame, SATBox box)
{
    SATBox inside;
    if (frame.edge >= SAT_EDGE_REPEAT)
    {
        float2 periodTexels = (frame.edge == SAT_EDGE_MIRROR ? 2.0 : 1.0) * float2(frame.extentTexels);
        float2 shiftTexels = periodTexels * floor(box.loTexels / periodTexels);
        inside.loTexels = box.loTexels - shiftTexels;
        inside.hiTexels = box.hiTexels - shiftTexels;
        return inside;
    }
    inside.loTexels = clamp(box.loTexels, 0.0, float2(frame.extentTexels));
    inside.hiTexels = clamp(box.hiTexels, 0.0, float2(frame.extentTexels));
    return inside;
}

// SATBoxArea: area of a box, in texels.
float SATBoxArea(SATBox box)
{
    float2 sizeTexels = box.hiTexels - box.loTexels;
    return sizeTexels.x * sizeTexels.y;
}

// Where F of a whole corner comes from on one axis: F(corner) = sign * F(inside) + wholes * F(size).
struct SATPlace
{
    int inside;     // 0 <= inside <= size
    int sign;
    int wholes;     // how often all of the image lies before the corner
    bool isInside;  // the corner is one of the image: sign 1, wholes 0
};

// SATPlaceOf: any whole corner, left of the image and periods beyond it too.
//
// Crow 1984 (repeated textures)
SATPlace SATPlaceOf(int corner, int sizeTexels, int edge)
{
    SATPlace place;
    place.inside = clamp(corner, 0, sizeTexels);
    place.sign = 1;
    place.wholes = 0;
    place.isInside = true;
    if (edge >= SAT_EDGE_REPEAT)
    {
        int periodTexels = edge == SAT_EDGE_MIRROR ? 2 * sizeTexels : sizeTexels;
        int periods = corner >= 0 ? corner / periodTexels : -((periodTexels - 1 - corner) / periodTexels);
        int offset = corner - periods * periodTexels;
        bool isMirrored = offset > sizeTexels;
        place.inside = isMirrored ? 2 * sizeTexels - offset : offset;
        place.sign = isMirrored ? -1 : 1;
        place.isInside = corner == place.inside;
        place.wholes = (edge == SAT_EDGE_MIRROR ? 2 * periods : periods) + (isMirrored ? 2 : 0);
    }
    return place;
}

// SATLoadInside: F at a whole corner of the image, 0 <= corner <= extent. The address is clamped and what lies on the
// origin's lines is put to 0 by hand, because no sampler's address mode gives 0 on two sides and the last entry on the
// other two.
float4 SATLoadInside(Texture2D<float4> table, SATFrame frame, int2 corner)
{
    int2 side = sign(corner - frame.originTexels);
    int2 texel = int2(side.x > 0 ? corner.x - 1 : corner.x, side.y > 0 ? corner.y - 1 : corner.y);
    float4 value = table.Load(int3(clamp(texel, 0, frame.extentTexels - 1), 0));
    return float(side.x * side.y) * value;
}

// SATLoadCorner: F at any whole corner.
//
// Cost: 1 load; 4 where the image is repeated and the corner lies outside.
float4 SATLoadCorner(Texture2D<float4> table, SATFrame frame, int2 corner)
{
    SATPlace x = SATPlaceOf(corner.x, frame.extentTexels.x, frame.edge);
    SATPlace y = SATPlaceOf(corner.y, frame.extentTexels.y, frame.edge);
    float4 value = SATLoadInside(table, frame, int2(x.inside, y.inside));
    if (!x.isInside || !y.isInside)
    {
        int2 size = frame.extentTexels;
        value = float(x.sign * y.sign) * value
              + float(x.wholes * y.sign) * SATLoadInside(table, frame, int2(size.x, y.inside))
              + float(x.sign * y.wholes) * SATLoadInside(table, frame, int2(x.inside, size.y))
              + float(x.wholes * y.wholes) * SATLoadInside(table, frame, size);
    }
    return value;
}

// SATSumStrip: the sum over columns [loX, hiX) of rows [0, y), fractional in x, whole in y.
float4 SATSumStrip(Texture2D<float4> table, SATFrame frame, float loX, float hiX, int y)
{
    int lo = int(floor(loX));
    int hi = int(floor(hiX));
    float4 atLo = SATLoadCorner(table, frame, int2(lo, y));
    float4 atHi = SATLoadCorner(table, frame, int2(hi, y));
    float4 columnLo = SATLoadCorner(table, frame, int2(lo + 1, y)) - atLo;
    float4 columnHi = SATLoadCorner(table, frame, int2(hi + 1, y)) - atHi;
    return (atHi - atLo) + (hiX - hi) * columnHi - (loX - lo) * columnLo;
}

// SATSumBox: the sum of the source image over a box, weighted by coverage where an edge cuts a texel.
//
//   table    W x H inclusive table of the source, float32
//   frame   how it lies over the image
//   box      from SATClipBox
//   returns  sum per channel, in the source's units x texels
//
// Error:  at most (4 d + 20) u S, where u = 2^-24, d = ceil(log2 W) + ceil(log2 H) is the depth of the tree by which
//         sat_build.hlsli adds, and S the sum of the magnitudes of all texels: 4 d for the table's entries at four
//         corners, 20 for this lookup (SATFilter.IsWithinTheDocumentedBoundOfTheDefinition). 0 where S < 2^24 and both
//         the texels and the box's edges are whole numbers. Repeated images: S over all periods that the box reaches.
// Cost:   16 loads, no dependent reads; 64 where the image is repeated and the box lies outside.
//
// Crow 1984, sect. 2.1; Hensley 2005, sect. 2 (Fig. 2)
float4 SATSumBox(Texture2D<float4> table, SATFrame frame, SATBox box)
{
    float2 lo = box.loTexels;
    float2 hi = box.hiTexels;
    int top = int(floor(lo.y));
    int bottom = int(floor(hi.y));

    // Differences along x first: they cancel between entries of like size, before anything is rounded away.
    float4 atTop = SATSumStrip(table, frame, lo.x, hi.x, top);
    float4 atBottom = SATSumStrip(table, frame, lo.x, hi.x, bottom);
    float4 rowTop = SATSumStrip(table, frame, lo.x, hi.x, top + 1) - atTop;
    float4 rowBottom = SATSumStrip(table, frame, lo.x, hi.x, bottom + 1) - atBottom;
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
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_CLIP);
    SATBox box = SATClipBox(frame, SATBoxAt(TexelUvToEdge(uv, extentTexels), max(sizeTexels, 1.0)));
    float areaTexels = SATBoxArea(box);
    return areaTexels > 0.0 ? SATSumBox(table, frame, box) / areaTexels : (float4)0;
}

// SATSampleBoxZero: as SATSampleBox, but the image is 0 outside and the whole box divides: coverage fades at the rim.
//
// Crow 1984 (where truncated coordinates meet an untruncated area)
float4 SATSampleBoxZero(Texture2D<float4> table, int2 extentTexels, float2 uv, float2 sizeTexels)
{
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_ZERO);
    SATBox whole = SATBoxAt(TexelUvToEdge(uv, extentTexels), max(sizeTexels, 1.0));
    return SATSumBox(table, frame, SATClipBox(frame, whole)) / SATBoxArea(whole);
}

// SATSampleBoxRepeat: as SATSampleBox, but the image is repeated without end: any uv, and boxes of many periods.
//
// Crow 1984 (repeated textures)
float4 SATSampleBoxRepeat(Texture2D<float4> table, int2 extentTexels, float2 uv, float2 sizeTexels)
{
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_REPEAT);
    SATBox box = SATBoxAt(TexelUvToEdge(uv, extentTexels), max(sizeTexels, 1.0));
    return SATSumBox(table, frame, SATClipBox(frame, box)) / SATBoxArea(box);
}

#endif
