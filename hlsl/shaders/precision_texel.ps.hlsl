// precision_texel.ps: the source as it is summed: less the bias, or as whole codes; in the table's precision. With a
// frame, the texels of the frame are 0, not 0 - bias.
// Hensley 2005, sect. 4.2.1; Scheuermann 2005 (the frame)
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/precision_constants.h"
#include "shaders/precision_number.hlsli"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { PrecisionTexelConstants g; };
Texture2D<float4> source : register(t0);

Number main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy) - g.frameTexels;
    int2 inside = clamp(texel, 0, g.extentTexels - 1);
    float4 value = source.Load(int3(inside, 0));
    if (texel.x != inside.x || texel.y != inside.y)
        return (Number)0;
#if PRECISION == u32
    return uint4(max(value * g.scale + 0.5, 0.0));
#else
    return Stored(value - g.bias);
#endif
}
