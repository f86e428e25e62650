// sat_pass_io.hlsli: what sat_pass.vs hands to sat_pass.ps. TAPS is set on the compiler's command line.
struct SATPassVertex
{
    float4 position : SV_Position;
    float4 uv[TAPS / 2] : TEXCOORD0;  // TAPS uvs, two to a float4: .xy and .wz
};
