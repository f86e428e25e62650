// The source less a constant.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { SubtractConstants g; };
Texture2D<float4> source : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    return source.Load(int3(TexelFromEdge(i.position.xy), 0)) - g.value;
}
