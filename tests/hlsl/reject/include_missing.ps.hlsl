// flags: -T ps_5_0 -I include
// expect: include_missing.ps.hlsl:3:1: error: '#include': cannot find 'missing.hlsli'; searched: ., include
#include "missing.hlsli"

float4 main() : SV_Target0
{
    return 1;
}
