// One buffer to another: 2 n + 1 of each number.
StructuredBuffer<uint> before : register(t0);
RWStructuredBuffer<uint> after : register(u0);

[numthreads(64, 1, 1)]
void main(uint thread : SV_DispatchThreadID)
{
    uint count, strideBytes;
    after.GetDimensions(count, strideBytes);
    if (thread < count)
        after[thread] = 2u * before[thread] + 1u;
}
