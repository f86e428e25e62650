// flags: -T ps_5_0
// expect: missing_semicolon.ps.hlsl:8:5: error: expected ';'
// expect: missing_semicolon.ps.hlsl:8:5: error: expected declaration

float4 main() : SV_Target0
{
    float x = 1
    return x;
}
