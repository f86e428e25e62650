// A repeated texture on a plane, filtered over each pixel's footprint: uv = across * x + down * y + start.
#include "boxcar/compat.hlsli"
#include "boxcar/footprint.hlsli"
#include "boxcar/sat.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { PlaneConstants g; };
Texture2D<float4> table : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    float2 uv = g.acrossUv * i.position.x + g.downUv * i.position.y + g.startUv;
    float2 rectangleUv = FootprintRectangle(ddx(uv), ddy(uv));
    return SATSampleBoxRepeat(table, g.extentTexels, uv, rectangleUv * float2(g.extentTexels));
}
