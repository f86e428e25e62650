// flags: -T ps_5_0
// expect: loose_global.ps.hlsl:5:7: error: 'scale' is a constant outside a cbuffer; put it into a named cbuffer with a register, or make it static const [loose_globals]
// expect: loose_global.ps.hlsl:5:14: error: 'unused' is a constant outside a cbuffer; put it into a named cbuffer with a register, or make it static const [loose_globals]

float scale, unused;
static const float kFine = 2.0;

float4 main() : SV_Target0
{
    return scale * kFine;
}
