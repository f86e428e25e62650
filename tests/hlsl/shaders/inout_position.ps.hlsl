// Shows what was interpolated, and x of the texel that it stands in.
struct Corner
{
    float2 uv : TEXCOORD0;
    float4 position : SV_Position0;
    float2 twice : TEXCOORD1;
};

float4 main(Corner i) : SV_Target0
{
    return float4(i.uv, i.twice.x, i.position.x);
}
