// flags: -T cs_5_0
// expect: missing_numthreads.cs.hlsl:5:6: error: 'main' has no [numthreads(x, y, z)] [missing_numthreads]
RWStructuredBuffer<uint> counts : register(u0);

void main(uint3 id : SV_DispatchThreadID)
{
    counts[id.x] = 1;
}
