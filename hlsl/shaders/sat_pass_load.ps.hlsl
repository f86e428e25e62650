// sat_pass_load.ps: one pass of building the table, by integer address.
// Hensley 2005, sect. 3
#include "boxcar/compat.hlsli"
#include "boxcar/sat_build.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATPassConstants g; };
Texture2D<float4> source : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    SATTaps taps = SATTapsOf(TexelFromEdge(i.position.xy), g.originTexels, g.strideTexels);
#if TAPS == 2
    return SATPassLoad2(source, taps, 0);
#elif TAPS == 4
    return SATPassLoad4(source, taps, 0);
#elif TAPS == 8
    return SATPassLoad8(source, taps, 0);
#else
    return SATPassLoad16(source, taps, 0);
#endif
}
