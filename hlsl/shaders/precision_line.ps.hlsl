// precision_line.ps: one row or column of a serial scan: the source plus the line before it, which is in the other
// target. (Green's slides read and write one texture, whose results they call undefined.)
// Green 2003 ("Building Summed Area Tables using Hardware")
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/precision_constants.h"
#include "shaders/precision_number.hlsli"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { PrecisionLineConstants g; };
Texture2D<float4> source : register(t0);
Texture2D<float4> before : register(t1);

float4 main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy);
    int2 previous = texel - g.stepTexels.xy;
    float4 sum = before.Load(int3(max(previous, 0), 0));
    if (previous.x < 0 || previous.y < 0)
        sum = (float4)0;
    return Stored(Added(sum + source.Load(int3(texel, 0))));
}
