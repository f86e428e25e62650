// precision_frame_pass.ps: one pass with four taps of the papers' other boundary set-up: a black frame of one texel and
// clamping to the edge, instead of a border colour.
// Scheuermann 2005 ("Boundary Conditions")
#include "boxcar/sat_build.hlsli"
#include "shaders/sat_pass_io.hlsli"

Texture2D<float4> source : register(t0);
SamplerState nearestClamp : register(s0);

float4 main(SATPassVertex i) : SV_Target0
{
    return SATPass4(source, nearestClamp, i.uv);
}
