// half.ps: an image half as large: a level of a mip map. Every texel counts as much: on an odd side a texel of the result
// lies over more than two of the image's.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> finer : register(t0);

// Weights of texels 2 i, 2 i + 1 and 2 i + 2.
float3 HalfWeights(int i, int sizeTexels)
{
    int halfTexels = sizeTexels / 2;
    float3 weights = float3(0.5, 0.5, 0.0);
    if (sizeTexels == 1)
        weights = float3(1.0, 0.0, 0.0);
    else if (sizeTexels != 2 * halfTexels)
        weights = float3(halfTexels - i, halfTexels, i + 1) / sizeTexels;
    return weights;
}

float4 main(QuadVertex v) : SV_Target0
{
    int2 extentTexels;
    finer.GetDimensions(extentTexels.x, extentTexels.y);
    int2 texel = TexelFromEdge(v.position.xy);
    float3 weightsX = HalfWeights(texel.x, extentTexels.x), weightsY = HalfWeights(texel.y, extentTexels.y);
    float4 mean = (float4)0;
    for (int y = 0; y < 3; y++)
    {
        for (int x = 0; x < 3; x++)
            mean += weightsX[x] * weightsY[y] * finer.Load(int3(min(2 * texel + int2(x, y), extentTexels - 1), 0));
    }
    return mean;
}
