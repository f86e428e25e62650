// The vertex shader of the link_*.ps.hlsl.
struct VsOut
{
    float4 position : SV_Position;
    float2 key : KEY;
    float2 uv : TEXCOORD0;
    float4 color[2] : COLOR;
};

VsOut main(uint id : SV_VertexID)
{
    return (VsOut)0;
}
