// lens_mips.ps: depth of field from a mip map. Without noise, samples of three levels are combined so that their variance is
// that of the circle of confusion (Ashikhmin 2002). With it, one sample of the level whose texels are as wide as the circle;
// noise over level and place hides the steps of the map (Demers 2004).
// Hensley 2005, sect. 2.2 and 5.4 (what tables are compared with)
#include "boxcar/compat.hlsli"
#include "boxcar/footprint.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { LensMipsConstants g; };
Texture2D<float4> picture : register(t0);  // disparity in alpha
Texture2D<float4> mips : register(t1);
SamplerState linearClamp : register(s0);

// NoiseAt: three numbers in [-1, 1], the same for a texel every frame.
float3 NoiseAt(int2 texel)
{
    uint3 seed = (uint(texel.x) * 1597334677u ^ uint(texel.y) * 3812015801u) * uint3(1u, 2654435761u, 2246822519u);
    seed ^= seed >> 15;
    seed *= 2146121005u;
    seed ^= seed >> 13;
    return float3(seed & 0xffffu) / 32767.5 - 1.0;
}

float4 main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy);
    int2 extentTexels;
    picture.GetDimensions(extentTexels.x, extentTexels.y);
    float widthTexels = FootprintLens(picture.Load(int3(texel, 0)).a, g.focusDisparity, g.apertureTexels);
    if (g.noiseLevels == 0.0)
    {
        // A bilinear sample of level l has the variance 4^l / 4 on an axis, a disc of diameter c has c^2 / 16. Levels
        // l - 1, l, l + 1 by 1/4, 1/2, 1/4 have 25/64 4^l.
        float2 centreUv = TexelEdgeToUv(i.position.xy, extentTexels);
        float middle = log2(0.4 * widthTexels);
        return 0.25 * mips.SampleLevel(linearClamp, centreUv, middle - 1.0)
             + 0.50 * mips.SampleLevel(linearClamp, centreUv, middle)
             + 0.25 * mips.SampleLevel(linearClamp, centreUv, middle + 1.0);
    }
    float3 noise = widthTexels > 1.0 ? g.noiseLevels * NoiseAt(texel) : float3(0.0, 0.0, 0.0);
    float2 uv = TexelEdgeToUv(i.position.xy + 0.5 * widthTexels * noise.xy, extentTexels);
    return mips.SampleLevel(linearClamp, uv, log2(widthTexels) + noise.z);
}
