// flags: -T ps_5_0 --after include/link.vs.hlsl
// expect: link_type.ps.hlsl:9:12: error: 'float4 key : KEY0' has location 0, where the vertex shader writes 'float2 key : KEY0'; use one struct for both stages [stage_link]
// expect: include/link.vs.hlsl:5:12: note: it is written here
// expect: link_type.ps.hlsl:12:9: error: the vertex shader does not write 'float3 extra : EXTRA0'; use one struct for both stages [stage_link]

struct PsIn
{
    float4 position : SV_Position;
    float4 key : KEY;
    float2 uv : TEXCOORD0;
    float4 color[2] : COLOR;
 float3 extra : EXTRA;
};

float4 main(PsIn i) : SV_Target0
{
    return i.key + i.extra.xyzz;
}
