// quad.vs: covers the target; hands on the uv.
#include "shaders/quad.hlsli"
#include "shaders/quad_io.hlsli"

QuadVertex main(uint vertexId : SV_VertexID)
{
    QuadVertex o;
    o.uv = QuadUv(vertexId);
    o.position = QuadPosition(o.uv);
    return o;
}
