// texture_halve.ps: the next mip level of a texture that is repeated, by weighted means: 4 x 4 texels, 1 3 3 1 on either
// axis. (half.ps takes plain ones.)
// Crow 1984, sect. 4 (what a filter might do)
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

Texture2D<float4> finer : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    static const float kWeights[4] = { 1.0, 3.0, 3.0, 1.0 };
    int2 extentTexels;
    finer.GetDimensions(extentTexels.x, extentTexels.y);
    int2 first = 2 * TexelFromEdge(i.position.xy) - 1;
    float4 sum = (float4)0;
    for (int y = 0; y < 4; y++)
    {
        for (int x = 0; x < 4; x++)
        {
            int2 texel = first + int2(x, y);
            texel -= extentTexels * int2(floor(float2(texel) / float2(extentTexels)));
            sum += kWeights[x] * kWeights[y] * finer.Load(int3(texel, 0));
        }
    }
    return sum / 64.0;
}
