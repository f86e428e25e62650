// Tents and parabolic kernels from a table of two words, the centre moved off the texel's; clipped.
#include "boxcar/compat.hlsli"
#include "boxcar/sat_order.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { SampleConstants g; };
Texture2D<uint4> table : register(t0);
Texture2D<uint4> tableHigh : register(t1);

float4 main(QuadVertex i) : SV_Target0
{
    SATExactTable words = SATTable64(table, tableHigh, false);
    float2 centre = i.position.xy + g.offsetTexels;
    float mass = SATMassOrder(ORDER, centre.x, g.sizeTexels.x, g.extentTexels.x)
               * SATMassOrder(ORDER, centre.y, g.sizeTexels.y, g.extentTexels.y);
    return SATSumOrder(words, g.extentTexels, ORDER, centre, g.sizeTexels) / mass;
}
