// flags: -T ps_5_0
// expect: binding_clash_cbuffer.ps.hlsl:6:9: error: 'Later' is on register(b0), where 'Early' is [binding_clash]
// expect: binding_clash_cbuffer.ps.hlsl:5:9: note: 'Early' is declared here

cbuffer Early : register(b0) { float4 a; };
cbuffer Later : register(b0) { float4 b; };

float4 main() : SV_Target0
{
    return a + b;
}
