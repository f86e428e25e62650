// flags: -T ps_5_0 --after position0.vs.hlsl
// expect: link_refused_partner.ps.hlsl:9:20: error: 'float2 uv : TEXCOORD0' has location 0, where the vertex shader writes 'float4 position : POSITION0'; use one struct for both stages [stage_link]
// expect: position0.vs.hlsl:7:23: note: it is written here
// expect: link_refused_partner.ps.hlsl:9:8: error: 'main' does not take 'float2 uv : TEXCOORD0'; use one struct for both stages [stage_link]
// expect: position0.vs.hlsl:7:52: note: it is written here
// expect: position0.vs.hlsl:8:8: error: 'main' does not write SV_Position [missing_position]
// expect: position0.vs.hlsl:7:23: note: POSITION is an ordinary output, not the position

float4 main(float2 uv : TEXCOORD0) : SV_Target0
{
    return uv.xyxy;
}
