// sat_pass.vs: the uvs of all taps of one pass, computed four times a pass instead of once a texel and tap.
// Scheuermann 2005 ("SAT Creation Vertex Shader", 16 uvs); its pow(16, fPassIndex) comes in as a whole number.
#include "boxcar/compat.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad.hlsli"
#include "shaders/sat_pass_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATPassConstants g; };

SATPassVertex main(uint vertexId : SV_VertexID)
{
    SATPassVertex o;
    float2 uv = QuadUv(vertexId);
    o.position = QuadPosition(uv);
    [unroll]
    for (int i = 0; i < TAPS / 2; i++)
    {
        o.uv[i].xy = uv - (2.0 * i) * g.strideUv;
        o.uv[i].wz = uv - (2.0 * i + 1.0) * g.strideUv;
    }
    return o;
}
