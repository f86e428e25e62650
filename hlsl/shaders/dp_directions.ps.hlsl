// dp_directions.ps: the lookup texture: the direction of every texel of a face.
// Scheuermann 2005 (precomputed lookup textures)
#include "boxcar/compat.hlsli"
#include "boxcar/dual_paraboloid.hlsli"
#include "constants/dp_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { DPFaceConstants g; };

float4 main(QuadVertex i) : SV_Target0
{
    return float4(DPUvToDirection(i.uv, g.face), DPWeight(i.uv, g.sideTexels));
}
