// precision_green.hlsli: Green's lookup by corner and size in pixels.
#ifndef BOXCAR_PRECISION_GREEN_HLSLI
#define BOXCAR_PRECISION_GREEN_HLSLI

#include "boxcar/sat.hlsli"

// texRECT_summedArea: the mean over the pixels x .. x + a - 1, y .. y + b - 1.
//
//   table         W x H inclusive table
//   extentTexels  (W, H)
//   xy            the corner of least x and y, in whole pixels; the rectangle lies inside the image
//   ab            width and height, in whole pixels, 1 or more
//
// The slide's minus signs are lost in print, and its four nearest lookups at xy and xy + ab leave out the first row
// and column (they cover x + 1 .. x + a): here they are a pixel less, and 0 outside of the table.
//
// Cost:  4 loads
//
// Green 2003 ("SAT Texture Decode")
float4 texRECT_summedArea(Texture2D<float4> table, int2 extentTexels, int2 xy, int2 ab)
{
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_CLIP);
    float4 r;
    r = SATLoadCorner(table, frame, xy + ab);
    r -= SATLoadCorner(table, frame, xy + int2(ab.x, 0));
    r -= SATLoadCorner(table, frame, xy + int2(0, ab.y));
    r += SATLoadCorner(table, frame, xy);
    return r / float(ab.x * ab.y);
}

#endif
