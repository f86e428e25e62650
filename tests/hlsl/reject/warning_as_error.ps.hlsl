// flags: -T ps_5_0 -WX
// expect: warning_as_error.ps.hlsl:4:2: error: 'earlydepth': unrecognized attribute

[earlydepth] float4 main() : SV_Target0
{
    return 1;
}
