// flags: -T ps_5_0
// expect: binding_clash.ps.hlsl:7:19: error: 'second' is on register(t3), where 'first' is [binding_clash]
// expect: include/first.hlsli:2:19: note: 'first' is declared here
#include "include/first.hlsli"

#define DECLARE(name, slot) Texture2D<float4> name : register(slot)
Texture2D<float4> second : register(t3);
DECLARE(unused, t3);

float4 main() : SV_Target0
{
    return first.Load(int3(0, 0, 0)) + second.Load(int3(0, 0, 0));
}
