// scene.vs: places a mesh in the world.
#include "shaders/scene_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SceneConstants g; };

SceneVertex main(float3 position : POSITION, float3 normal : NORMAL, float2 uv : TEXCOORD0)
{
    SceneVertex o;
    o.positionWorld = g.offsetWorld + g.scale * Turned(g, position);
    o.position = mul(g.clipFromWorld, float4(o.positionWorld, 1.0));
    o.normalWorld = Turned(g, normal);
    o.uv = uv;
    return o;
}
