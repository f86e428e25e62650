// precision_box.ps: the box round every texel, clipped to the image: its mean in float32, or under u32 its sum modulo
// 2^32. The box is of odd size, so four loads are enough; their differences are taken in SATSumBox's order.
//
// A table that is summed outwards from a middle holds the integral from there but for its sign: at corner i of an axis
// the integral is T(i - 1) right of the middle, -T(i) left of it and 0 on it.
// Crow 1984, sect. 2.1; Hensley 2005, sect. 4.2
#include "boxcar/compat.hlsli"
#include "boxcar/sat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/precision_constants.h"
#include "shaders/precision_number.hlsli"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { PrecisionBoxConstants g; };
Texture2D<Number> table : register(t0);

Number Integral(int2 corner)
{
    int2 texel = corner;
    if (corner.x > g.middleTexels.x)
        texel.x--;
    if (corner.y > g.middleTexels.y)
        texel.y--;
    Number value = table.Load(int3(clamp(texel, 0, g.extentTexels - 1) + g.frameTexels.x, 0));
    if ((corner.x < g.middleTexels.x) != (corner.y < g.middleTexels.y))
        value = (Number)0 - value;
    return (corner.x == g.middleTexels.x || corner.y == g.middleTexels.y) ? (Number)0 : value;
}

Number main(QuadVertex i) : SV_Target0
{
    SATFrame frame = SATFrameAtCorner(g.extentTexels, SAT_EDGE_CLIP);
    SATBox box = SATClipBox(frame, SATBoxAt(i.position.xy, float2(g.sizeTexels)));
    int2 lo = int2(box.loTexels);
    int2 hi = int2(box.hiTexels);
    Number top = Integral(int2(hi.x, lo.y)) - Integral(lo);
    Number bottom = Integral(hi) - Integral(int2(lo.x, hi.y));
    Number sum = bottom - top;
#if PRECISION == u32
    return sum;
#else
    return sum / SATBoxArea(box) + g.bias;
#endif
}
