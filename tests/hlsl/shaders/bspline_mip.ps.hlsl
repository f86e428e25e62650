// A mip-mapped picture on a plane, uv = across * x + down * y + start, under the cubic B-spline: its colour, and the level that
// was taken. FORM says how that was found out.
#include "boxcar/bspline_mip.hlsli"
#include "boxcar/compat.hlsli"
#include "shaders/quad_io.hlsli"
#include "test_constants.h"

#define PLAIN 0
#define ONE_LEVEL 1
#define META_NEAREST 2
#define META_LINEAR 3
#define LINE_NEAREST 4
#define LINE_LINEAR 5
#define QUERY 6
#define MOVED 7

BOXCAR_CONSTANTS(Constants) { MipConstants g; };
Texture2D<float4> source : register(t0);
Texture2D<float4> meta : register(t1);
Texture2D<float4> metaLine : register(t2);
SamplerState linearClamp : register(s0);
SamplerState nearestClamp : register(s1);

struct Result
{
    float4 colour : SV_Target0;
    float4 level : SV_Target1;
};

Result main(QuadVertex i)
{
    float2 uv = g.acrossUv * i.position.x + g.downUv * i.position.y + g.startUv;
    Result r;
    r.colour = (float4)0;
    r.level = (float4)0;
#if FORM == PLAIN
    r.colour = BSplineSample2D(source, linearClamp, g.extentTexels, uv);
#elif FORM == ONE_LEVEL
    r.colour = BSplineSampleLevel2D(source, linearClamp, g.extentTexels, uv, g.level);
#elif FORM == META_NEAREST
    r.level = BSplineMetaLevel2D(meta, nearestClamp, uv);
    r.colour = BSplineSampleMeta2D(source, meta, linearClamp, nearestClamp, uv);
#elif FORM == META_LINEAR
    r.level = BSplineMetaLevel2D(meta, linearClamp, uv);
    r.colour = BSplineSampleMip2D(source, linearClamp, g.extentTexels, uv, r.level.x);
#elif FORM == LINE_NEAREST
    r.level = BSplineMetaLevel1D(metaLine, nearestClamp, g.extentTexels, uv, g.baseLevel);
    r.colour = BSplineSampleLevel2D(source, linearClamp, g.extentTexels, uv, int(r.level.x));
#elif FORM == LINE_LINEAR
    r.level = BSplineMetaLevel1D(metaLine, linearClamp, g.extentTexels, uv, g.baseLevel);
    r.colour = BSplineSampleMip2D(source, linearClamp, g.extentTexels, uv, r.level.x);
#elif FORM == QUERY
    r.level = source.CalculateLevelOfDetail(linearClamp, uv);
    r.colour = BSplineSampleTrilinear2D(source, linearClamp, g.extentTexels, uv);
#else
    // What a sampler finds at the first fetch's place instead of the pixel's.
    int2 levelTexels = BSplineLevelExtent(g.extentTexels, g.level);
    float2 edgeTexels = TexelUvToEdge(uv, levelTexels);
    float2 t = BSplinePointOf(edgeTexels).t;
    float2 moved = edgeTexels - float2(BSplineHG(t.x).x, BSplineHG(t.y).x);
    r.level = source.CalculateLevelOfDetail(linearClamp, TexelEdgeToUv(moved, levelTexels));
#endif
    return r;
}
