// Atomics whose operand is of another type than the memory, on each kind of memory; 64 threads of one group.
RWByteAddressBuffer bytes : register(u0);
RWStructuredBuffer<uint> results : register(u1);
RWStructuredBuffer<int> signedResults : register(u2);
groupshared uint total;
groupshared int least;

[numthreads(64, 1, 1)]
void main(uint thread : SV_GroupIndex)
{
    int negative = -int(thread);
    if (thread == 0)
    {
        total = 0;
        least = 0;
    }
    GroupMemoryBarrierWithGroupSync();

    InterlockedAdd(total, 1);
    InterlockedMin(least, negative);
    InterlockedAdd(results[0], 1);
    InterlockedMax(signedResults[0], thread);

    bytes.InterlockedAdd(0, 1);
    bytes.InterlockedAdd(4, -1);
    bytes.InterlockedMin(8, -1);  // unsigned: 0xffffffff is the largest
    bytes.InterlockedMax(12, negative);
    bytes.InterlockedOr(16, 1 << (thread & 3));
    bytes.InterlockedAnd(20, ~(1 << (thread & 3)));
    bytes.InterlockedXor(24, 3);
    int before;
    bytes.InterlockedAdd(28, 1.75, before);  // a float counts as 1
    bytes.InterlockedAdd(32, thread > 31);   // a bool as 1 or 0
    bytes.InterlockedExchange(36, 7, before);
    bytes.InterlockedCompareExchange(40, 5, negative - 1, before);  // one thread finds the 5
    if (before == 5)
        bytes.InterlockedAdd(44, 1);
    bytes.InterlockedCompareStore(48, 6, 9);
    InterlockedCompareStore(results[1], 6, 9);
    InterlockedCompareStore(signedResults[1], -6, -9);
    if (thread == 0)
    {
        bytes.Store2(52, 3);
        bytes.Store3(60, thread + 4u);
        bytes.Store4(72, -1.0 * negative + 5.5);
    }

    GroupMemoryBarrierWithGroupSync();
    if (thread == 0)
    {
        results[2] = total;
        signedResults[2] = least;
    }
}
