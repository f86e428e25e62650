// resize.ps: a picture at another size, made larger. FILTER is NEAREST, LINEAR, BSPLINE or CATMULL_ROM; the edge texel goes
// on outside.
// Sigg 2005, sect. 20.1 (Fig. 20-3)
#include "boxcar/bspline_sample.hlsli"
#include "boxcar/compat.hlsli"
#include "constants/bspline_constants.h"
#include "shaders/quad_io.hlsli"

#define NEAREST 0
#define LINEAR 1
#define BSPLINE 3
#define CATMULL_ROM 4

BOXCAR_CONSTANTS(Constants) { ResizeConstants g; };
Texture2D<float4> source : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    float2 edgeTexels = i.position.xy * g.stepTexels;
    BSplinePoint p = BSplinePointOf(edgeTexels);
#if FILTER == NEAREST
    return source.Load(int3(clamp(TexelFromEdge(edgeTexels), 0, g.extentTexels - 1), 0));
#elif FILTER == LINEAR
    return BSplineSum2D(source, g.extentTexels, p.first, float4(0.0, 1.0 - p.t.x, p.t.x, 0.0),
                        float4(0.0, 1.0 - p.t.y, p.t.y, 0.0));
#elif FILTER == BSPLINE
    return BSplineLoad2D(source, g.extentTexels, edgeTexels);
#else
    return CatmullRomLoad2D(source, g.extentTexels, edgeTexels);
#endif
}
