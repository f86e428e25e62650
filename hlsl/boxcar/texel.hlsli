// texel.hlsli: uv <-> edge coordinates <-> texels. The only file that knows that a texel's centre lies half a texel in.
//
//   uv      [0, 1] across the image, origin top-left
//   edge    uv * extent: texel (i, j) covers [i, i + 1) x [j, j + 1); its centre is (i + 0.5, j + 0.5)
//   texel   integer address
#ifndef BOXCAR_TEXEL_HLSLI
#define BOXCAR_TEXEL_HLSLI

// TexelUvToEdge: edge coordinates of a uv.
float2 TexelUvToEdge(float2 uv, int2 extentTexels)
{
    return uv * float2(extentTexels);
}

// TexelEdgeToUv: uv of edge coordinates; the inverse of TexelUvToEdge.
float2 TexelEdgeToUv(float2 edgeTexels, int2 extentTexels)
{
    return edgeTexels / float2(extentTexels);
}

// TexelFromEdge: the texel that covers a point.
int2 TexelFromEdge(float2 edgeTexels)
{
    return int2(floor(edgeTexels));
}

// TexelCentre: edge coordinates of a texel's centre. Exact for every address below 2^23.
float2 TexelCentre(int2 texel)
{
    return float2(texel) + 0.5;
}

#endif
