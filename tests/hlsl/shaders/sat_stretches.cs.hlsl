// The stretches that a box takes from an axis.
#include "boxcar/sat_exact.hlsli"

RWStructuredBuffer<float2> boxes : register(u0);    // a thread: where the box begins and ends
RWStructuredBuffer<float4> results : register(u1);  // a thread: corners, high and low of the weights

[numthreads(64, 1, 1)]
void main(uint3 thread : SV_DispatchThreadID)
{
    SATStretches s = SATStretchesOf(boxes[thread.x].x, boxes[thread.x].y);
    results[3u * thread.x] = float4(s.corner);
    results[3u * thread.x + 1u] = s.weight.high;
    results[3u * thread.x + 2u] = s.weight.low;
}
