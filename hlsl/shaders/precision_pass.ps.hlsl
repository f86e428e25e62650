// precision_pass.ps: one pass of building a table, as sat_pass_load.ps, in the arithmetic of PRECISION. Its taps and its
// additions are those of sat_pass_load.ps.
// Hensley 2005, sect. 3 and 4.2.2
#include "boxcar/compat.hlsli"
#include "boxcar/sat_build.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/sat_constants.h"
#include "shaders/precision_number.hlsli"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATPassConstants g; };
Texture2D<Number> source : register(t0);

Number Sum1(SATTaps taps, int i)
{
    bool counts = SATTapCounts(taps, i);
    Number value = source.Load(int3(taps.texel + (counts ? i : 0) * taps.strideTexels, 0));
    return counts ? value : (Number)0;
}

Number Sum2(SATTaps taps, int i)
{
    return Added(Sum1(taps, i) + Sum1(taps, i + 1));
}

Number Sum4(SATTaps taps, int i)
{
    return Added(Sum2(taps, i) + Sum2(taps, i + 2));
}

Number Sum8(SATTaps taps, int i)
{
    return Added(Sum4(taps, i) + Sum4(taps, i + 4));
}

Number Sum16(SATTaps taps, int i)
{
    return Added(Sum8(taps, i) + Sum8(taps, i + 8));
}

Number main(QuadVertex i) : SV_Target0
{
    SATTaps taps = SATTapsOf(TexelFromEdge(i.position.xy), g.originTexels, g.strideTexels);
#if TAPS == 2
    return Stored(Sum2(taps, 0));
#elif TAPS == 4
    return Stored(Sum4(taps, 0));
#elif TAPS == 8
    return Stored(Sum8(taps, 0));
#else
    return Stored(Sum16(taps, 0));
#endif
}
