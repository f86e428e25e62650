// isosurface_shade.ps: the colour of the points that isosurface_march.ps found, once a pixel.
//
//   FILTER   TRILINEAR: derivatives by differences over a voxel; TRICUBIC: those of the cubic B-spline
//
// Sigg 2005, sect. 20.4 (Figs 20-4 and 20-5); Kindlmann 2003 (transfer functions of two curvatures)
#include "boxcar/bspline_volume.hlsli"
#include "boxcar/compat.hlsli"
#include "constants/isosurface_constants.h"
#include "shaders/quad_io.hlsli"

#define TRILINEAR 0
#define TRICUBIC 1

BOXCAR_CONSTANTS(Constants) { IsosurfaceShadeConstants g; };
Texture3D<float> volume : register(t0);
Texture2D<float4> hits : register(t1);
SamplerState linearClamp : register(s0);

float At(float3 edgeVoxels, int3 extent)
{
    return volume.SampleLevel(linearClamp, edgeVoxels / float3(extent), 0.0);
}

BSplineDerivatives3D Derivatives(float3 p, int3 extent)
{
#if FILTER == TRICUBIC
    return BSplineHessian3D(volume, extent, p);
#else
    static const float3 x = float3(1.0, 0.0, 0.0), y = float3(0.0, 1.0, 0.0), z = float3(0.0, 0.0, 1.0);
    BSplineDerivatives3D d;
    d.value = At(p, extent);
    float3 behind = float3(At(p - x, extent), At(p - y, extent), At(p - z, extent));
    float3 ahead = float3(At(p + x, extent), At(p + y, extent), At(p + z, extent));
    d.gradient = 0.5 * (ahead - behind);
    d.pure = ahead - 2.0 * d.value + behind;
    d.mixed = 0.25 * float3(At(p + y + z, extent) - At(p + y - z, extent) - At(p - y + z, extent) + At(p - y - z, extent),
                            At(p + x + z, extent) - At(p + x - z, extent) - At(p - x + z, extent) + At(p - x - z, extent),
                            At(p + x + y, extent) - At(p + x - y, extent) - At(p - x + y, extent) + At(p - x - y, extent));
    return d;
#endif
}

// The normal of the volume's side that a point lies on.
float3 SideNormal(float3 p, float3 extent)
{
    float3 inside = min(p, extent - p);
    float3 outwards = float3(p.x < 0.5 * extent.x ? -1.0 : 1.0, p.y < 0.5 * extent.y ? -1.0 : 1.0,
                             p.z < 0.5 * extent.z ? -1.0 : 1.0);
    return inside.x <= inside.y && inside.x <= inside.z ? float3(outwards.x, 0.0, 0.0)
         : inside.y <= inside.z                         ? float3(0.0, outwards.y, 0.0)
                                                        : float3(0.0, 0.0, outwards.z);
}

// From concave by valleys, saddles and ridges to convex; grey where the surface is flat.
float3 CurvatureColour(float2 kappa)
{
    static const float3 concave = float3(0.10, 0.05, 0.40), valley = float3(0.03, 0.22, 0.62), saddle = float3(0.22, 0.50, 0.16),
                        ridge = float3(0.92, 0.52, 0.06), convex = float3(0.70, 0.08, 0.03), plain = float3(0.62, 0.60, 0.56);
    float spread = max(kappa.x - kappa.y, 1e-9);
    float index = 4.0 * (0.5 + atan((kappa.x + kappa.y) / spread) / 3.14159265);  // 0 concave, 2 saddle, 4 convex
    float3 hue = lerp(lerp(concave, valley, saturate(index)), saddle, saturate(index - 1.0));
    hue = lerp(lerp(hue, ridge, saturate(index - 2.0)), convex, saturate(index - 3.0));
    return lerp(plain, hue, saturate(g.radiusMillimetres * sqrt(0.5 * dot(kappa, kappa))));
}

float3 RidgesColour(float2 kappa)
{
    float bent = g.radiusMillimetres * (max(kappa.x, 0.0) + min(kappa.y, 0.0));  // saddles are neither
    float ridge = smoothstep(0.7, 1.6, bent);
    float valley = smoothstep(0.7, 1.6, -bent);
    float3 colour = lerp(float3(0.50, 0.40, 0.33), float3(0.98, 0.93, 0.84), ridge);
    return lerp(colour, float3(0.045, 0.025, 0.02), valley);
}

// Of the larger curvature: blue where even that one bends inwards, white where it is flat, red on ridges and bumps.
float3 MaximumColour(float kappa)
{
    static const float3 inwards = float3(0.03, 0.16, 0.60), plain = float3(0.88, 0.86, 0.82), outwards = float3(0.70, 0.06, 0.03);
    float bent = g.radiusMillimetres * kappa;
    return lerp(lerp(plain, inwards, saturate(-bent)), outwards, saturate(bent));
}

float4 main(QuadVertex i) : SV_Target0
{
    float3 background = lerp(float3(0.86, 0.87, 0.89), float3(0.52, 0.54, 0.58), i.uv.y);
    float4 hit = hits.Load(int3(i.position.xy, 0));
    int3 extent;
    volume.GetDimensions(extent.x, extent.y, extent.z);
    BSplineDerivatives3D d = BSplineScaled(Derivatives(hit.xyz, extent), g.voxelMillimetres);
    bool isSide = hit.w > 1.5;
    float3 normal = isSide ? SideNormal(hit.xyz, float3(extent)) : -d.gradient / max(length(d.gradient), 1e-20);
    float2 kappa = isSide ? float2(0.0, 0.0) : BSplineCurvature(d.gradient, d.pure, d.mixed);

    float3 view = normalize(g.eyeMillimetres - hit.xyz * g.voxelMillimetres);
    float3 middle = normalize(view + g.lightMillimetres);
    float lamp = max(dot(normal, g.lightMillimetres), 0.0);
    float3 normalWorld = float3(dot(normal, g.worldX), dot(normal, g.worldY), dot(normal, g.worldZ));
    float sky = 0.5 + 0.5 * normalWorld.z;
    float diffuse = 0.80 * lamp + 0.12 * max(dot(normal, view), 0.0) + 0.02 + 0.10 * sky;
    float highlight = lamp > 0.0 ? 0.22 * pow(max(dot(normal, middle), 0.0), 48.0) : 0.0;
    float3 colour = 0.5 + 0.5 * normalWorld;
    if (g.shade == ISOSURFACE_PHONG)
        colour = float3(0.84, 0.60, 0.48) * diffuse + highlight;
    else if (g.shade == ISOSURFACE_CURVATURE)
        colour = CurvatureColour(kappa) * (0.2 + 0.9 * diffuse);
    else if (g.shade == ISOSURFACE_RIDGES)
        colour = RidgesColour(kappa) * (0.35 + 0.75 * diffuse);
    else if (g.shade == ISOSURFACE_MAXIMUM)
        colour = MaximumColour(kappa.x) * (0.2 + 0.9 * diffuse);
    return float4(hit.w > 0.5 ? colour : background, 1.0);
}
