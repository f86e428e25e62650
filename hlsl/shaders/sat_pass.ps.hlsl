// sat_pass.ps: one pass of building the table, by interpolated uv.
// Scheuermann 2005 ("SAT Creation Pixel Shader")
#include "boxcar/sat_build.hlsli"
#include "shaders/sat_pass_io.hlsli"

Texture2D<float4> source : register(t0);
SamplerState nearestBorder : register(s0);

float4 main(SATPassVertex i) : SV_Target0
{
#if TAPS == 2
    return SATPass2(source, nearestBorder, i.uv[0]);
#elif TAPS == 4
    return SATPass4(source, nearestBorder, i.uv);
#elif TAPS == 8
    return SATPass8(source, nearestBorder, i.uv);
#else
    return SATPass16(source, nearestBorder, i.uv);
#endif
}
