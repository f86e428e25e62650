// flags: -T ps_5_0 --after include/link.vs.hlsl
// expect: link_order.ps.hlsl:11:12: error: 'float2 uv : TEXCOORD0' has location 0, where the vertex shader writes 'float2 key : KEY0'; use one struct for both stages [stage_link]
// expect: include/link.vs.hlsl:5:12: note: it is written here
// expect: link_order.ps.hlsl:12:12: error: 'float2 key : KEY0' has location 1, where the vertex shader writes 'float2 uv : TEXCOORD0'; use one struct for both stages [stage_link]
// expect: include/link.vs.hlsl:6:12: note: it is written here

// The same fields in another order: crosswise.
struct PsIn
{
    float4 position : SV_Position;
    float2 uv : TEXCOORD0;
    float2 key : KEY;
    float4 color[2] : COLOR;
};

float4 main(PsIn i) : SV_Target0
{
    return i.uv.xyxy + i.key.xyxy + i.color[1];
}
