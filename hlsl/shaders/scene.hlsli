// scene.hlsli: how the sample scenes are lit: a sun, a sky above and the ground's glow from below, on matt surfaces.
#ifndef BOXCAR_SCENE_HLSLI
#define BOXCAR_SCENE_HLSLI

static const float3 kSunWorld = float3(0.4286, 0.7715, 0.4714);  // towards it, length 1
static const float3 kSunLight = float3(0.78, 0.72, 0.62);
static const float3 kSkyLight = float3(0.34, 0.38, 0.46);
static const float3 kGroundLight = float3(0.16, 0.14, 0.12);

// SceneLight: what a white matt surface gives off.
//
//   normalWorld  length 1
//   sunShare     how much of the sun it sees, 0 to 1
float3 SceneLight(float3 normalWorld, float sunShare)
{
    float3 ambient = lerp(kGroundLight, kSkyLight, 0.5 + 0.5 * normalWorld.y);
    return ambient + sunShare * saturate(dot(normalWorld, kSunWorld)) * kSunLight;
}

// SceneStripes: the share of [x - width / 2, x + width / 2] that lies in odd unit stretches, so that checks far away
// become grey and do not flicker.
float SceneStripes(float x, float width)
{
    float w = max(width, 1e-3);
    float2 ends = 0.5 * float2(x - 0.5 * w, x + 0.5 * w);
    float2 inside = floor(ends) + saturate(2.0 * frac(ends) - 1.0);  // integral of the odd stretches, in pairs
    return saturate((inside.y - inside.x) / (0.5 * w));
}

// SceneChecks: 0 on the dark squares of a board of unit squares, 1 on the light ones, filtered over a pixel.
float SceneChecks(float2 p)
{
    float2 width = max(abs(ddx(p)), abs(ddy(p)));
    float u = SceneStripes(p.x, width.x), v = SceneStripes(p.y, width.y);
    return u + v - 2.0 * u * v;
}

// SceneWallPoint: x and z along the surface that a point is on, for checks on all walls of a room.
float3 SceneWallPoint(float3 positionWorld, float3 normalWorld)
{
    float3 onSurface = positionWorld;
    if (abs(normalWorld.y) < 0.7)
    {
        float2 across = normalize(float2(normalWorld.z, -normalWorld.x));
        onSurface = float3(dot(across, positionWorld.xz), 0.0, positionWorld.y);
    }
    return onSurface;
}

// SceneAlbedo: an object's colour at a point: plain, or a board of it and a darker one along x and z.
//
//   checkWorld  side of its squares; 0 for none
float3 SceneAlbedo(float3 albedo, float checkWorld, float3 positionWorld)
{
    float share = SceneChecks(positionWorld.xz / max(checkWorld, 1e-3));
    return checkWorld > 0.0 ? albedo * lerp(0.35, 1.0, share) : albedo;
}

#endif
