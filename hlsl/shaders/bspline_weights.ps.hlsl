// bspline_weights.ps: the weights of the cubic B-spline or of its first or second derivative, ORDER, as a picture: texel x of
// N is the point (x + 0.5) / N between two texels.
// Sigg 2005, Fig. 20-1
#include "boxcar/bspline.hlsli"
#include "boxcar/compat.hlsli"
#include "constants/bspline_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { BSplineWeightsConstants g; };

float4 main(QuadVertex i) : SV_Target0
{
    float t = i.position.x / g.points;
#if ORDER == 0
    return BSplineWeights(t);
#elif ORDER == 1
    return BSplineWeights1(t);
#else
    return BSplineWeights2(t);
#endif
}
