// flags: -T ps_5_0
// expect: include/loose.hlsli:3:7: error: 'loose' is a constant outside a cbuffer; put it into a named cbuffer with a register, or make it static const [loose_globals]
#include "include/loose.hlsli"

float4 main() : SV_Target0
{
    return loose;
}
