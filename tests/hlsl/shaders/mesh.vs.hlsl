// A mesh, moved by a matrix; hands on all that its vertices hold. The inputs stand in another order than in the buffer.
#include "boxcar/compat.hlsli"
#include "mesh_io.hlsli"
#include "test_constants.h"

BOXCAR_CONSTANTS(Constants) { MeshConstants g; };

MeshVertex main(float2 uv : TEXCOORD0, float3 normal : NORMAL, float3 position : POSITION)
{
    MeshVertex o;
    o.position = mul(g.clipFromMesh, float4(position, 1.0));
    o.normal = normal;
    o.uv = uv;
    return o;
}
