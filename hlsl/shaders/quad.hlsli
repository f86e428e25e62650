// quad.hlsli: the screen-aligned quad that every image-to-image pass draws, as a triangle strip of four vertices and no
// vertex buffer: vertex 0..3 = left top, right top, left bottom, right bottom.
#ifndef BOXCAR_QUAD_HLSLI
#define BOXCAR_QUAD_HLSLI

// QuadUv: uv of a corner, origin top-left.
float2 QuadUv(uint vertexId)
{
    return float2(vertexId & 1u, vertexId >> 1u);
}

// QuadPosition: its place in Direct3D's clip space, y up. The runtime turns the viewport over for Vulkan.
float4 QuadPosition(float2 uv)
{
    return float4(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y, 0.0, 1.0);
}

#endif
