// flags: -T ps_5_0
// expect: include/wrong.hlsli:4:12: error: 'undeclared': unknown variable
// expect: include/wrong.hlsli:4:5: error: 'return': type does not match, or is not convertible to, the function's return type
// expect: error_in_include.ps.hlsl:11: error: expected declaration
#include "include/wrong.hlsli"

float4 main() : SV_Target0
{
    return Wrong();
}
