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
    int2 texel = TexelFromEdge(i.position.xy);
#if TAPS == 2
    return SATPassLoad2(source, texel, g.strideTexels);
#elif TAPS == 4
    return SATPassLoad4(source, texel, g.strideTexels);
#elif TAPS == 8
    return SATPassLoad8(source, texel, g.strideTexels);
#else
    return SATPassLoad16(source, texel, g.strideTexels);
#endif
}
