// flags: -T ps_5_0 -E Main
// expect: missing_entry.ps.hlsl:1: error: there is no entry point 'Main' [missing_entry]

float4 main() : SV_Target0
{
    return 1;
}
