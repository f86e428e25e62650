// precision_merge.ps: the lines of two targets that took turns: every second one from each.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/precision_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { PrecisionLineConstants g; };
Texture2D<float4> even : register(t0);
Texture2D<float4> odd : register(t1);

float4 main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy);
    int2 along = texel * g.stepTexels.xy;
    float4 fromEven = even.Load(int3(texel, 0));
    float4 fromOdd = odd.Load(int3(texel, 0));
    return ((along.x + along.y) & 1) == 0 ? fromEven : fromOdd;
}
