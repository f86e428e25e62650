// Green's lookup with its corner at each texel; 0 where the rectangle leaves the image.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/precision_constants.h"
#include "shaders/precision_green.hlsli"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { PrecisionBoxConstants g; };
Texture2D<float4> table : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy);
    int2 end = texel + g.sizeTexels;
    if (end.x > g.extentTexels.x || end.y > g.extentTexels.y)
        return (float4)0;
    return texRECT_summedArea(table, g.extentTexels, texel, g.sizeTexels);
}
