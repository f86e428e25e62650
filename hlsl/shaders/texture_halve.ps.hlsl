// texture_halve.ps: the next mip level of a texture that is repeated.
//
//   BOX       the mean of the 2 x 2 texels under it
//   BINOMIAL  of 4 x 4, weighted 1 3 3 1 on either axis
//
// Crow 1984, sect. 4 (unweighted means, and what a filter might do)
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

#define BOX 2
#define BINOMIAL 4

Texture2D<float4> finer : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    static const float kWeights[4] = { 1.0, 3.0, 3.0, 1.0 };
    int2 extentTexels;
    finer.GetDimensions(extentTexels.x, extentTexels.y);
    int2 first = 2 * TexelFromEdge(i.position.xy) - (KERNEL - 2) / 2;
    float4 sum = (float4)0;
    float total = 0.0;
    for (int y = 0; y < KERNEL; y++)
    {
        for (int x = 0; x < KERNEL; x++)
        {
            int2 texel = first + int2(x, y);
            texel -= extentTexels * int2(floor(float2(texel) / float2(extentTexels)));
            float weight = KERNEL == BOX ? 1.0 : kWeights[x] * kWeights[y];
            sum += weight * finer.Load(int3(texel, 0));
            total += weight;
        }
    }
    return sum / total;
}
