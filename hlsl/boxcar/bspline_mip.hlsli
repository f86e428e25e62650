// bspline_mip.hlsli: the cubic B-spline of mip-mapped pictures.
//
//   BSplineSampleLevel2D     of one level: MIPMAP_NEAREST
//   BSplineSampleMip2D       of two levels, blended: MIPMAP_LINEAR
//   which level it is:
//   BSplineMetaLevel2D       by a meta-mipmap of the picture's extent
//   BSplineMetaLevel1D       by one that is a line of texels, for every extent
//   BSplineSampleMeta2D      MIPMAP_NEAREST in one call as the chapter has it, extents too from the meta-mipmap
//   BSplineSampleTrilinear2D MIPMAP_LINEAR by CalculateLevelOfDetail: what to use today
//
// A sampler knows the level that it takes, and does not say so; but the offsets of the fetches depend on it. So the level is
// asked for first, where the coordinates are smooth, and then named in the fetches. The chapter does not name it: but the moved
// coordinates jump from texel to texel, and a sampler finds other levels there (BSplineMip.MovedCoordinatesFindOtherLevels).
//
// All but BSplineSampleLevel2D and BSplineSampleMip2D: pixel shaders, outside of branches.
//
// Sigg 2005, sect. 20.3
#ifndef BOXCAR_BSPLINE_MIP_HLSLI
#define BOXCAR_BSPLINE_MIP_HLSLI

#include "boxcar/bspline_sample.hlsli"

// BSplineLevelExtent: width and height of a level: halved, rounded down, at least 1.
int2 BSplineLevelExtent(int2 extentTexels, int level)
{
    return max(int2(extentTexels.x >> level, extentTexels.y >> level), 1);
}

// BSplineSampleLevel2D: the spline of one level.
//
//   source        with mip levels
//   linearClamp   linear filter
//   extentTexels  of level 0
//   uv            [0, 1] across the picture
//   level         a whole one, from 0 to the last
//
// Error: BSplineSample2D's, of the level's picture (BSplineMip.OneLevelIsThePlainFormOnItsPicture).
// Cost:  4 linear fetches.
float4 BSplineSampleLevel2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv, int level)
{
    return BSplineSampleOf2D(source, linearClamp, BSplineLevelExtent(extentTexels, level), uv, level);
}

// BSplineSampleMip2D: the splines of the two levels about `level`, by its fraction.
//
//   level  from 0 to the last
//
// Cost: 8 linear fetches.
float4 BSplineSampleMip2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv, float level)
{
    int finer = int(floor(level));
    return lerp(BSplineSampleLevel2D(source, linearClamp, extentTexels, uv, finer),
                BSplineSampleLevel2D(source, linearClamp, extentTexels, uv, finer + 1), level - finer);
}

// BSplineMetaLevel2D: the level that a sampler takes from a texture of the meta-mipmap's extent.
//
//   meta       runtime/passes/meta_mipmap.h
//   metaClamp  nearest between levels: a whole level; linear: with the fraction
float BSplineMetaLevel2D(Texture2D<float4> meta, SamplerState metaClamp, float2 uv)
{
    return meta.Sample(metaClamp, uv).z;
}

// BSplineMetaLevel1D: the level that a sampler takes from a texture of any extent: derivatives are stretched as if the
// meta-mipmap had that extent.
//
//   meta          one texel high, seen from its base level: as many levels as the texture has
//   extentTexels  of the texture
//   baseLevel     which level of the whole meta-mipmap is the first here (MetaBaseLevel)
float BSplineMetaLevel1D(Texture2D<float4> meta, SamplerState metaClamp, int2 extentTexels, float2 uv, int baseLevel)
{
    int2 metaTexels;
    meta.GetDimensions(metaTexels.x, metaTexels.y);
    float2 adjust = float2(extentTexels) / float2(metaTexels);
    return meta.SampleGrad(metaClamp, uv, ddx(uv) * adjust, ddy(uv) * adjust).z - baseLevel;
}

// BSplineSampleMeta2D: the spline of the level that a sampler takes, without constants.
//
//   meta          of the source's extent
//   nearestClamp  nearest between levels
//
// Cost: 4 linear fetches and 1 of the meta-mipmap.
float4 BSplineSampleMeta2D(Texture2D<float4> source, Texture2D<float4> meta, SamplerState linearClamp,
                           SamplerState nearestClamp, float2 uv)
{
    float4 level = meta.Sample(nearestClamp, uv);
    return BSplineSampleOf2D(source, linearClamp, int2(round(1.0 / level.xy)), uv, level.z);
}

// BSplineSampleTrilinear2D: the splines of the two levels that a sampler takes, blended as it would.
//
//   extentTexels  of level 0
//
// Cost: 8 linear fetches and 1 query.
float4 BSplineSampleTrilinear2D(Texture2D<float4> source, SamplerState linearClamp, int2 extentTexels, float2 uv)
{
    float level = source.CalculateLevelOfDetail(linearClamp, uv);
    return BSplineSampleMip2D(source, linearClamp, extentTexels, uv, level);
}

#endif
