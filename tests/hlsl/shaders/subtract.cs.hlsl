// What subtract.ps does, as a compute shader that writes an image.
#include "boxcar/compat.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { SubtractConstants g; };
Texture2D<float4> source : register(t0);
RWTexture2D<float4> target : register(u0);

[numthreads(8, 4, 1)]
void main(uint3 thread : SV_DispatchThreadID)
{
    uint2 extentTexels;
    target.GetDimensions(extentTexels.x, extentTexels.y);
    if (all(thread.xy < extentTexels))
        target[thread.xy] = source.Load(int3(thread.xy, 0)) - g.value;
}
