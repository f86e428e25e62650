// sat_filter.ps: the mean over a box round every texel. EDGE_ZERO = 0: the box is clipped to the image and divided by
// the area that is left; 1: the image is 0 outside and the whole box divides.
// Crow 1984, sect. 2.1; Hensley 2005, sect. 4.2.1 (the bias, added back over the area that carried it)
#include "boxcar/compat.hlsli"
#include "boxcar/sat.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATFilterConstants g; };
Texture2D<float4> table : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    SATBox box = SATClipBox(g.extentTexels, i.position.xy, g.sizeTexels);
    float insideTexels = SATBoxArea(box);
    float4 sum = SATSumBox(table, g.extentTexels, box);
#if EDGE_ZERO
    float2 wholeTexels = max(g.sizeTexels, 1.0);
    return (sum + insideTexels * g.bias) / (wholeTexels.x * wholeTexels.y);
#else
    return sum / insideTexels + g.bias;
#endif
}
