// footprint.hlsli: how large a box a pixel, a gloss, a lens asks for.
#ifndef BOXCAR_FOOTPRINT_HLSLI
#define BOXCAR_FOOTPRINT_HLSLI

// FootprintRectangle: the upright rectangle of texture that a pixel covers.
//
//   ddxUv, ddyUv  how far the texture coordinate moves from one pixel to the next, across and down
//   returns       width and height, in uv: of the two movements the larger, for u and for v
//
// Their sum would hold the pixel's parallelogram; the larger one blurs less and aliases little (Crow 1984, sect. 3).
//
// Cost: 2 comparisons.
float2 FootprintRectangle(float2 ddxUv, float2 ddyUv)
{
    return max(abs(ddxUv), abs(ddyUv));
}

#endif
