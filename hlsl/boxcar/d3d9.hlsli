// d3d9.hlsli: opt in. Lets the listings of 2003 to 2005 stand with their bodies as printed: `sampler` and `tex2D` become
// macros over a Texture2D with its SamplerState. Include it last: the macros rename those words in all that follows.
//
//   sampler tSAT = D3D9Sampler(table, nearestClamp);
//   float4 mean = tex2D_SAT_blur(tSAT, uv, size);
#ifndef BOXCAR_D3D9_HLSLI
#define BOXCAR_D3D9_HLSLI

struct D3D9TextureAndSampler
{
    Texture2D<float4> t;
    SamplerState s;
};

D3D9TextureAndSampler D3D9Sampler(Texture2D<float4> t, SamplerState s)
{
    D3D9TextureAndSampler both;
    both.t = t;
    both.s = s;
    return both;
}

float4 D3D9Tex2D(D3D9TextureAndSampler both, float2 uv)
{
    return both.t.Sample(both.s, uv);
}

#define sampler D3D9TextureAndSampler
#define tex2D D3D9Tex2D

// tex2D_SAT_blur: the box lookup exactly as printed, kept for comparison; use SATSampleBox.
//
//   tSAT     an inclusive table
//   uv       [0, 1] across the image
//   size     of the box, in uv
//   returns  W x H times the mean (it divides by an area in uv), of a box that lies half a texel too far to the right
//            and down for even sizes and a whole one for odd, not clipped at the rim (SATVerbatimBlur.*)
//
// Scheuermann 2005
float4 tex2D_SAT_blur(sampler tSAT, float2 uv, float2 size)
{
    float4 result = tex2D(tSAT, uv + 0.5 * size);           // LR
    result -= tex2D(tSAT, uv + float2(0.5, -0.5) * size); // UR
    result -= tex2D(tSAT, uv + float2(-0.5, 0.5) * size); // LL
    result += tex2D(tSAT, uv - 0.5 * size);                // UL
    result /= size.x * size.y;

    return result;
}

#endif
