// The stacks of boxes: texel (i, k) is box i of k + 1.
#include "boxcar/box_stack.hlsli"
#include "boxcar/texel.hlsli"
#include "shaders/quad_io.hlsli"

float4 main(QuadVertex i) : SV_Target0
{
    int2 texel = TexelFromEdge(i.position.xy);
    return float4(BoxStack(texel.y + 1, min(texel.x, texel.y)), 0.0, 0.0);
}
