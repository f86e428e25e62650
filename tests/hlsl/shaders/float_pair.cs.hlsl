// Every operation on pairs of floats, four lanes a thread.
#include "boxcar/float_pair.hlsli"

RWStructuredBuffer<float4> operands : register(u0);  // a thread: high of a and b, low of a and b
RWStructuredBuffer<float4> results : register(u1);   // a thread: high and low of each result

void Write(uint index, FloatPair pair)
{
    results[2u * index] = pair.high;
    results[2u * index + 1u] = pair.low;
}

[numthreads(64, 1, 1)]
void main(uint3 thread : SV_DispatchThreadID)
{
    uint from = 4u * thread.x;
    FloatPair a = FloatPairOf(operands[from], operands[from + 2u]);
    FloatPair b = FloatPairOf(operands[from + 1u], operands[from + 3u]);
    uint to = 9u * thread.x;
    Write(to, FloatPairSum(a.high, b.high));
    Write(to + 1u, FloatPairOrdered(a.high, a.low));
    Write(to + 2u, FloatPairSplit(a.high));
    Write(to + 3u, FloatPairProduct(a.high, b.high));
    Write(to + 4u, FloatPairAdd(a, b));
    Write(to + 5u, FloatPairSub(a, b));
    Write(to + 6u, FloatPairMul(a, b));
    Write(to + 7u, FloatPairDiv(a, b));
    Write(to + 8u, FloatPairSqrt(abs(a.high)));
}
