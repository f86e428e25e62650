// flags: -T vs_3_0
// expect: position0.vs.hlsl:8:8: error: 'main' does not write SV_Position [missing_position]
// expect: position0.vs.hlsl:7:23: note: POSITION is an ordinary output, not the position

// As Direct3D 9 shaders wrote it.
struct VsIn { float4 position : POSITION; };
struct VsOut { float4 position : POSITION0; float2 uv : TEXCOORD0; };
VsOut  main(VsIn i)
{
    VsOut o;
    o.position = i.position;
    o.uv = i.position.xy;
    return o;
}
