// quad_io.hlsli: what quad.vs hands to the pixel shaders.
#ifndef BOXCAR_QUAD_IO_HLSLI
#define BOXCAR_QUAD_IO_HLSLI

struct QuadVertex
{
    float4 position : SV_Position;
    float2 uv : TEXCOORD0;
};

#endif
