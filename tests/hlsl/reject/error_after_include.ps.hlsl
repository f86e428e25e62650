// flags: -T ps_5_0
// expect: error_after_include.ps.hlsl:10:12: error: 'undeclared': unknown variable
// expect: error_after_include.ps.hlsl:10:5: error: 'return': type does not match, or is not convertible to, the function's return type
// expect: error_after_include.ps.hlsl:10:22: error: expected declaration
#define UNUSED
#include "include/first.hlsli"

float4 main() : SV_Target0
{
    return undeclared;
}
