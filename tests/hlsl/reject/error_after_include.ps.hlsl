// flags: -T ps_5_0
// expect: error_after_include.ps.hlsl:8:12: error: 'undeclared': unknown variable
#define UNUSED
#include "include/first.hlsli"

float4 main() : SV_Target0
{
    return undeclared;
}
