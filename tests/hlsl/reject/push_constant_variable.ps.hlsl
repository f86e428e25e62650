// flags: -T ps_5_0
// expect: push_constant_variable.ps.hlsl:5:30: error: 'push' is a constant outside a cbuffer; put it into a named cbuffer with a register, or make it static const [loose_globals]

struct Push { float4 tint; };
[[vk::push_constant]] Push   push;

float4 main() : SV_Target0
{
    return push.tint;
}
