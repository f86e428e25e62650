// flags: -T vs_5_0
// expect: missing_position.vs.hlsl:4:8: error: 'main' does not write SV_Position [missing_position]

float4 main(float4 position : POSITION) : COLOR0
{
    return position;
}
