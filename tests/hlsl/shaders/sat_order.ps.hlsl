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
    float2 after = float2(g.extentTexels) - centre;
    FloatPair mass = FloatPairMul(SATMassOrder(ORDER, g.sizeTexels.x, centre.x, after.x),
                                  SATMassOrder(ORDER, g.sizeTexels.y, centre.y, after.y));
    FloatPair sum = SATSumOrder(words, g.extentTexels, ORDER, int2(0, 0), centre, g.sizeTexels, false, false);
    return FloatPairToFloat(FloatPairDiv(sum, mass));
}
