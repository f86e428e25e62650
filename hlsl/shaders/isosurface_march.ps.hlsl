// isosurface_march.ps: where the ray of a pixel first meets the value, from front to back.
//
//   FILTER   TRILINEAR, or TRICUBIC: the cubic B-spline in 8 linear fetches
//   returns  .xyz: the point, in voxels from the volume's corner; .w: 0 no hit, 1 the surface, 2 the volume's side, behind
//            which values are as large already
//
// The ray is looked at every step of one sequence, of which those in blocks that stay below the value are passed over: so
// blocks cost time only, never another picture. Between the step before the value is reached and that step the place is
// narrowed down by the Illinois rule.
#include "boxcar/bspline_volume.hlsli"
#include "boxcar/compat.hlsli"
#include "constants/isosurface_constants.h"
#include "shaders/isosurface.hlsli"
#include "shaders/quad_io.hlsli"

#define TRILINEAR 0
#define TRICUBIC 1

BOXCAR_CONSTANTS(Constants) { IsosurfaceMarchConstants g; };
Texture3D<float> volume : register(t0);
Texture2D<float> blockMaxima : register(t1);
SamplerState linearClamp : register(s0);

static const int kNarrowings = 5;

float Above(float3 edgeVoxels, int3 extent)
{
    float3 uvw = edgeVoxels / float3(extent);
#if FILTER == TRICUBIC
    return BSplineSample3D(volume, linearClamp, extent, uvw) - g.iso;
#else
    return volume.SampleLevel(linearClamp, uvw, 0.0) - g.iso;
#endif
}

float4 main(QuadVertex i) : SV_Target0
{
    int3 extent;
    volume.GetDimensions(extent.x, extent.y, extent.z);
    int3 blocks = IsosurfaceBlocks(extent);
    float2 p = float2(2.0 * i.uv.x - 1.0, 1.0 - 2.0 * i.uv.y);
    float3 ray = normalize(g.forwardVoxels + p.x * g.rightVoxels + p.y * g.upVoxels);
    ray += float3(abs(ray.x) < 1e-7 ? 1e-7 : 0.0, abs(ray.y) < 1e-7 ? 1e-7 : 0.0, abs(ray.z) < 1e-7 ? 1e-7 : 0.0);
    float3 a = -g.eyeVoxels / ray, b = (float3(extent) - g.eyeVoxels) / ray;
    float3 enters = min(a, b), leaves = max(a, b);
    float tNear = max(max(max(enters.x, enters.y), enters.z), 0.0);
    float tFar = min(min(leaves.x, leaves.y), leaves.z);
    float last = tFar > tNear ? ceil((tFar - tNear) / g.stepVoxels) : -1.0;

    float k = 0.0;
    bool isHit = false;
    [loop]
    while (k <= last && !isHit)
    {
        int3 block = int3(0, 0, 0);
        [loop]
        while (k <= last)
        {
            float t = min(tNear + k * g.stepVoxels, tFar);
            float3 at = clamp(g.eyeVoxels + t * ray, 0.0, float3(extent));
            block = min(IsosurfaceBlockOf(at), blocks - 1);
            if (blockMaxima.Load(int3(IsosurfaceBlockTexel(block, blocks, g.blocksAcross), 0)) >= g.iso)
                break;
            float3 side = float3(block * kBlockCells) + 0.5;
            float3 goes = float3(ray.x > 0.0 ? side.x + kBlockCells - at.x : block.x > 0 ? side.x - at.x : -1e6,
                                 ray.y > 0.0 ? side.y + kBlockCells - at.y : block.y > 0 ? side.y - at.y : -1e6,
                                 ray.z > 0.0 ? side.z + kBlockCells - at.z : block.z > 0 ? side.z - at.z : -1e6) / ray;
            float tOut = t + min(min(goes.x, goes.y), goes.z);
            k = max(k + 1.0, ceil((tOut - tNear) / g.stepVoxels));
        }
        [loop]
        while (k <= last && !isHit)
        {
            float3 at = clamp(g.eyeVoxels + min(tNear + k * g.stepVoxels, tFar) * ray, 0.0, float3(extent));
            int3 leaving = abs(min(IsosurfaceBlockOf(at), blocks - 1) - block);
            if (leaving.x + leaving.y + leaving.z > 0)
                break;
            isHit = Above(at, extent) >= 0.0;
            k += isHit ? 0.0 : 1.0;
        }
    }

    float hi = min(tNear + k * g.stepVoxels, tFar), lo = max(tNear + (k - 1.0) * g.stepVoxels, tNear);
    float aboveHi = Above(g.eyeVoxels + hi * ray, extent), aboveLo = Above(g.eyeVoxels + lo * ray, extent);
    float t = hi;
    float side = 0.0;  // of the last narrowing: 1 the far end was moved, -1 the near one
    [loop]
    for (int n = 0; n < kNarrowings; n++)
    {
        float rise = aboveHi - aboveLo;
        t = rise > 0.0 ? clamp((lo * aboveHi - hi * aboveLo) / rise, lo, hi) : hi;
        float above = Above(g.eyeVoxels + t * ray, extent);
        bool isFar = above >= 0.0;
        aboveLo *= isFar && side > 0.0 ? 0.5 : 1.0;
        aboveHi *= !isFar && side < 0.0 ? 0.5 : 1.0;
        hi = isFar ? t : hi;
        aboveHi = isFar ? above : aboveHi;
        lo = isFar ? lo : t;
        aboveLo = isFar ? aboveLo : above;
        side = isFar ? 1.0 : -1.0;
    }
    float3 found = clamp(g.eyeVoxels + (k > 0.0 ? t : tNear) * ray, 0.0, float3(extent));
    return isHit ? float4(found, k > 0.0 ? 1.0 : 2.0) : float4(0.0, 0.0, 0.0, 0.0);
}
