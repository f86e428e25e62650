// shadow_surface.ps: what the camera sees, to be lit later: where it is, which way it faces, its colour.
#include "shaders/scene.hlsli"
#include "shaders/scene_io.hlsli"

BOXCAR_CONSTANTS(Constants) { MattConstants g; };

struct Surface
{
    float4 position : SV_Target0;  // of the world; w: 1
    float4 normal : SV_Target1;
    float4 albedo : SV_Target2;
};

Surface main(SceneVertex i)
{
    Surface o;
    o.position = float4(i.positionWorld, 1.0);
    o.normal = float4(normalize(i.normalWorld), 0.0);
    o.albedo = float4(SceneAlbedo(g.scene.albedo, g.checkWorld, i.positionWorld), 1.0);
    return o;
}
