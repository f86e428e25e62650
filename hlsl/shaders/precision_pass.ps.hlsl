// precision_pass.ps: one pass of building a table, as sat_pass_load.ps, in the arithmetic of PRECISION and outwards
// from a middle: left and above of it the taps lie to the right and below. From the corner (a middle of 0) the
// additions are those of sat_pass_load.ps.
// Hensley 2005, sect. 3 and 4.2.2
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/precision_constants.h"
#include "shaders/precision_number.hlsli"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { PrecisionPassConstants g; };
Texture2D<Number> source : register(t0);

// `inwards`: one stride towards the middle. Taps beyond the middle are 0.
Number Sum1(int2 texel, int2 inwards, int tap)
{
    int2 address = texel + tap * inwards;
    bool sameColumn = (address.x >= g.middleTexels.x) == (texel.x >= g.middleTexels.x);
    bool sameRow = (address.y >= g.middleTexels.y) == (texel.y >= g.middleTexels.y);
    Number value = source.Load(int3(clamp(address, 0, g.extentTexels - 1), 0));
    return (sameColumn && sameRow) ? value : (Number)0;
}

Number Sum2(int2 texel, int2 inwards, int tap)
{
    return Added(Sum1(texel, inwards, tap) + Sum1(texel, inwards, tap + 1));
}

Number Sum4(int2 texel, int2 inwards, int tap)
{
    return Added(Sum2(texel, inwards, tap) + Sum2(texel, inwards, tap + 2));
}

Number Sum8(int2 texel, int2 inwards, int tap)
{
    return Added(Sum4(texel, inwards, tap) + Sum4(texel, inwards, tap + 4));
}

Number Sum16(int2 texel, int2 inwards, int tap)
{
    return Added(Sum8(texel, inwards, tap) + Sum8(texel, inwards, tap + 8));
}

Number main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy);
    int2 inwards = g.strideTexels.xy;
    if (texel.x >= g.middleTexels.x)
        inwards.x = -inwards.x;
    if (texel.y >= g.middleTexels.y)
        inwards.y = -inwards.y;
#if TAPS == 2
    return Stored(Sum2(texel, inwards, 0));
#elif TAPS == 4
    return Stored(Sum4(texel, inwards, 0));
#elif TAPS == 8
    return Stored(Sum8(texel, inwards, 0));
#else
    return Stored(Sum16(texel, inwards, 0));
#endif
}
