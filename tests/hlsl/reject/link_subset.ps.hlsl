// flags: -T ps_5_0 --after include/link.vs.hlsl
// expect: link_subset.ps.hlsl:10:53: error: 'float2 uv : TEXCOORD0' has location 0, where the vertex shader writes 'float2 key : KEY0'; use one struct for both stages [stage_link]
// expect: include/link.vs.hlsl:5:12: note: it is written here
// expect: link_subset.ps.hlsl:10:8: error: 'main' does not take 'float2 uv : TEXCOORD0'; use one struct for both stages [stage_link]
// expect: include/link.vs.hlsl:6:12: note: it is written here
// expect: link_subset.ps.hlsl:10:8: error: 'main' does not take 'float4 color[0] : COLOR0'; use one struct for both stages [stage_link]
// expect: include/link.vs.hlsl:7:12: note: it is written here
// expect: link_subset.ps.hlsl:10:8: error: 'main' does not take 'float4 color[1] : COLOR1'; use one struct for both stages [stage_link]
// expect: include/link.vs.hlsl:7:12: note: it is written here
float4 main(float4 position : SV_Position,   float2 uv : TEXCOORD0) : SV_Target0
{
    return uv.xyxy;
}
