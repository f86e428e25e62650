// flags: -T ps_5_0
// expect: loose_struct.ps.hlsl:5:45: error: 'light' is a constant outside a cbuffer; put it into a named cbuffer with a register, or make it static const [loose_globals]

// The line below is what people write for push constants; only the cbuffer form is that.
struct Light { float a, b; }; uniform Light light;

float4 main() : SV_Target0
{
    return light.a + light.b;
}
