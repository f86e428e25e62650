// resize_table.ps: a picture at another size, made smaller: under kernels as wide as the result's texels, from a table of
// whole numbers. On an axis that becomes larger they are one texel wide.
// Heckbert 1986, as in Hensley 2005, sect. 2
#include "boxcar/compat.hlsli"
#include "boxcar/sat_order.hlsli"
#include "constants/bspline_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { ResizeConstants g; };
Texture2D<uint4> table : register(t0);
Texture2D<uint4> tableHigh : register(t1);

float4 main(QuadVertex i) : SV_Target0
{
    SATExactTable words = SATTable64(table, tableHigh, g.isSigned != 0);
    float2 centre = i.position.xy * g.stepTexels;
    float2 sizeTexels = max(g.stepTexels, 1.0);
    float4 sum = SATSumOrder(words, g.extentTexels, g.order, centre, sizeTexels);
    float mass = SATMassOrder(g.order, centre.x, sizeTexels.x, g.extentTexels.x)
               * SATMassOrder(g.order, centre.y, sizeTexels.y, g.extentTexels.y);
    return sum / (mass * g.codeScale);
}
