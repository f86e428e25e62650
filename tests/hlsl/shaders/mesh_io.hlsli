// mesh_io.hlsli: what mesh.vs hands to mesh.ps.
struct MeshVertex
{
    float4 position : SV_Position;
    float3 normal : NORMAL;
    float2 uv : TEXCOORD0;
};
