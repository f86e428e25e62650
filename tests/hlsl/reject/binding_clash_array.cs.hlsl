// flags: -T cs_5_0
// expect: binding_clash_array.cs.hlsl:6:21: error: 'target' is on register(u2, space1), where 'targets' is [binding_clash]
// expect: binding_clash_array.cs.hlsl:5:21: note: 'targets' is declared here

RWTexture2D<float4> targets[2] : register(u1, space1);
RWTexture2D<float4> target : register(u2, space1);

[numthreads(1, 1, 1)]
void main(uint3 id : SV_DispatchThreadID)
{
    targets[0][id.xy] = 1;
    targets[1][id.xy] = 1;
    target[id.xy] = 1;
}
