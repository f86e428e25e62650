// flags: -T ps_5_0 --after include/link.vs.hlsl
// expect: link_subset.ps.hlsl:7:46: error: 'float2 uv : TEXCOORD0' would receive another output, for it has the same location, 0; let both stages share one struct [stage_link]
// expect: include/link.vs.hlsl:5:12: note: 'float2 key : KEY0' is written here
// expect: link_subset.ps.hlsl:7:8: error: 'main' takes only a part of what the vertex shader writes; let both stages share one struct [stage_link]
// expect: include/link.vs.hlsl:6:12: note: 'float2 uv : TEXCOORD0' is written here
// expect: include/link.vs.hlsl:7:12: note: 'float4 colour[0] : COLOR0' is written here
float4 main(float4 position : SV_Position,   float2 uv : TEXCOORD0) : SV_Target0
{
    return uv.xyxy;
}
