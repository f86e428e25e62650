// Shows what was interpolated: uv, normal.z, and a value that says which mesh it is.
#include "boxcar/compat.hlsli"
#include "mesh_io.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { MeshConstants g; };

float4 main(MeshVertex i) : SV_Target0
{
    return float4(i.uv, i.normal.z, g.value.x);
}
