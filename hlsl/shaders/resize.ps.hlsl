// resize.ps: along one axis, a picture at another size: under a kernel as wide as a texel of the source or of the result,
// whichever is wider. FILTER is NEAREST, LINEAR, BSPLINE or CATMULL_ROM; the edge texel goes on outside.
// Sigg 2005, sect. 20.1 (Fig. 20-3)
#include "boxcar/bspline.hlsli"
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/bspline_constants.h"
#include "shaders/quad_io.hlsli"

#define NEAREST 0
#define LINEAR 1
#define BSPLINE 2
#define CATMULL_ROM 3

BOXCAR_CONSTANTS(Constants) { ResizeConstants g; };
Texture2D<float4> source : register(t0);

static const float kReach = FILTER == LINEAR ? 1.0 : 2.0;

float Kernel(float distance)
{
#if FILTER == LINEAR
    return saturate(1.0 - abs(distance));
#elif FILTER == BSPLINE
    return BSplineKernel(distance);
#else
    return CatmullRomKernel(distance);
#endif
}

float4 main(QuadVertex i) : SV_Target0
{
    int2 extentTexels;
    source.GetDimensions(extentTexels.x, extentTexels.y);
    int2 texel = TexelFromEdge(i.position.xy);
    float centre = (g.alongX != 0 ? i.position.x : i.position.y) * g.stepTexels;
#if FILTER == NEAREST
    int place = int(floor(centre));
    int2 from = g.alongX != 0 ? int2(place, texel.y) : int2(texel.x, place);
    return source.Load(int3(clamp(from, 0, extentTexels - 1), 0));
#else
    float widthTexels = max(g.stepTexels, 1.0);
    int first = int(ceil(centre - 0.5 - kReach * widthTexels));
    int last = int(floor(centre - 0.5 + kReach * widthTexels));
    float4 sum = (float4)0;
    float weights = 0.0;
    [loop]
    for (int place = first; place <= last; place++)
    {
        float weight = Kernel((float(place) + 0.5 - centre) / widthTexels);
        int2 from = int2(texel.x, place);
        if (g.alongX != 0)
            from = int2(place, texel.y);
        sum += weight * source.Load(int3(clamp(from, 0, extentTexels - 1), 0));
        weights += weight;
    }
    return sum / weights;
#endif
}
