// flags: -T ps_5_0 --after position0.vs.hlsl
// expect: link_refused_partner.ps.hlsl:5:20: error: 'float2 uv : TEXCOORD0' would receive another output, for it has the same location, 0; let both stages share one struct [stage_link]
// expect: position0.vs.hlsl:7:21: note: 'float4 position : POSITION0' is written here

float4 main(float2 uv : TEXCOORD0) : SV_Target0
{
    return uv.xyxy;
}
