// mean.ps: one level of a mip chain that ends in the mean: each texel is the sum of the four under it, or of as many as
// there are, so that odd sizes lose nothing. The last level is divided by the number of all texels.
// Hensley 2005, sect. 4.2.1
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { MeanConstants g; };
Texture2D<float4> source : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    int2 first = 2 * TexelFromEdge(i.position.xy);
    bool hasRight = first.x + 1 < g.extentTexels.x;
    bool hasBelow = first.y + 1 < g.extentTexels.y;
    float4 sum = source.Load(int3(first, 0));
    if (hasRight)
        sum += source.Load(int3(first.x + 1, first.y, 0));
    if (hasBelow)
        sum += source.Load(int3(first.x, first.y + 1, 0));
    if (hasRight && hasBelow)
        sum += source.Load(int3(first + 1, 0));
    return sum / g.divisor;
}
