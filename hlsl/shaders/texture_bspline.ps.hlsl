// texture_bspline.ps: a texture with its mip levels under the cubic B-spline: both levels that a sampler takes, blended.
// Sigg 2005, sect. 20.3
#include "boxcar/bspline_mip.hlsli"
#include "shaders/textured.hlsli"

Texture2D<float4> pattern : register(t0);
SamplerState linearRepeat : register(s0);

float4 main(SceneVertex i) : SV_Target0
{
    int2 extentTexels;
    pattern.GetDimensions(extentTexels.x, extentTexels.y);
    return TexturedLight(i, BSplineSampleTrilinear2D(pattern, linearRepeat, extentTexels, TexturedUv(i)));
}
