// quad_io.hlsli: what quad.vs hands to the pixel shaders.
struct QuadVertex
{
    float4 position : SV_Position;
    float2 uv : TEXCOORD0;
};
