// flags: -T ps_5_0
// expect: include/wrong.hlsli:4:12: error: 'undeclared': unknown variable
#include "include/wrong.hlsli"

float4 main() : SV_Target0
{
    return Wrong();
}
