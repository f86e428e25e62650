// sat_filter_io.hlsli: what sat_filter.ps and sat_filter_exact.ps have in common.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATFilterConstants g; };
Texture2D<float4> widthMap : register(t2);  // of the result's extent, or one texel; red is read

// Width and height of the box at a texel of the result.
float2 SizeAt(int2 texel)
{
    float t = widthMap.Load(int3(min(texel, g.widthMapTexels - 1), 0)).r;
    return max(g.minTexels + t * (g.maxTexels - g.minTexels), 1.0);
}

// How many boxes stand for a disc of that size. Within one texel all are the same, and one rounds less than many.
int BoxesFor(float2 sizeTexels)
{
    return all(sizeTexels <= 1.0) ? 1 : g.boxes;
}
