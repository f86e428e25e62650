// A picture under a cubic filter, at a point off each texel's centre. FORM says which function, and what of it.
#include "boxcar/bspline_gradient.hlsli"
#include "boxcar/compat.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

#define SAMPLE 0
#define LOAD 1
#define CATMULL_SAMPLE 2
#define CATMULL_LOAD 3
#define SAMPLE_DX 4
#define SAMPLE_DY 5
#define LOAD_DX 6
#define LOAD_DY 7
#define LOAD_DXX 8
#define LOAD_DXY 9
#define LOAD_DYY 10

BOXCAR_CONSTANTS(Constants) { SampleConstants g; };
Texture2D<float4> source : register(t0);
SamplerState linearClamp : register(s0);

float4 main(QuadVertex i) : SV_Target0
{
    float2 edgeTexels = i.position.xy + g.offsetTexels;
    float2 uv = TexelEdgeToUv(edgeTexels, g.extentTexels);
    float4 dx = (float4)0, dy = (float4)0;
#if FORM == SAMPLE
    return BSplineSample2D(source, linearClamp, g.extentTexels, uv);
#elif FORM == LOAD
    return BSplineLoad2D(source, g.extentTexels, edgeTexels);
#elif FORM == CATMULL_SAMPLE
    return CatmullRomSample2D(source, linearClamp, g.extentTexels, uv);
#elif FORM == CATMULL_LOAD
    return CatmullRomLoad2D(source, g.extentTexels, edgeTexels);
#elif FORM == SAMPLE_DX || FORM == SAMPLE_DY
    BSplineGradient2D(source, linearClamp, g.extentTexels, uv, dx, dy);
    return FORM == SAMPLE_DX ? dx : dy;
#else
    BSplineDerivatives2D d = BSplineDerivativesLoad2D(source, g.extentTexels, edgeTexels);
    return FORM == LOAD_DX ? d.dx : FORM == LOAD_DY ? d.dy : FORM == LOAD_DXX ? d.dxx : FORM == LOAD_DXY ? d.dxy : d.dyy;
#endif
}
