// dual_paraboloid.hlsli: the sphere of directions on two square pictures.
//
// The front face holds the directions round -z, the back face those round +z. On a face a direction has the place p in the
// unit disc, y up, at the distance tan(a / 2) from its middle, a being the angle from the face's axis: the map is
// conformal, so a small circle of directions is a circle on the face. Outside the disc a face still goes on, into what
// the other face holds better, up to the axis of the other one, which it cannot hold.
//
//   DPDirectionToUv, DPUvToDirection    there and back
//   DPWeight                            what share of the sphere a texel stands for
//   DPSample                            one direction, from two pictures
//   DPCircleOf, DPBoxOf                 a cone of directions on a face
//
// Scheuermann 2005 (with its back face turned by 180 degrees, so that it fits its own lookup); Hensley 2005, sect. 5.1
#ifndef BOXCAR_DUAL_PARABOLOID_HLSLI
#define BOXCAR_DUAL_PARABOLOID_HLSLI

#include "boxcar/dual_paraboloid_range.h"
#include "boxcar/sat.hlsli"

#define DP_FRONT 0
#define DP_BACK 1

// DPAxisCosine: cosine of the angle between a direction and a face's axis.
//
//   dir   length 1
//   face  DP_FRONT or DP_BACK
float DPAxisCosine(float3 dir, int face)
{
    return face == DP_FRONT ? -dir.z : dir.z;
}

// DPFaceOf: the face whose disc holds a direction.
int DPFaceOf(float3 dir)
{
    return dir.z <= 0.0 ? DP_FRONT : DP_BACK;
}

// DPDiscToUv, DPUvToDisc: the unit disc, y up, and the uv of its picture.
float2 DPDiscToUv(float2 p)
{
    return 0.5 * float2(p.x, -p.y) + 0.5;
}

float2 DPUvToDisc(float2 uv)
{
    return float2(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y);
}

// DPDirectionToUv: where a face shows a direction. Not the axis of the other face, whose place is infinitely far away.
//
//   dir  length 1
//
// Scheuermann 2005 (texDP)
float2 DPDirectionToUv(float3 dir, int face)
{
    return DPDiscToUv(dir.xy / (1.0 + DPAxisCosine(dir, face)));
}

// DPUvToDirection: what a face shows at a uv; length 1. Outside of the disc: directions of the other face.
//
// Blythe 1999, as in Scheuermann 2005
float3 DPUvToDirection(float2 uv, int face)
{
    float2 p = DPUvToDisc(uv);
    float s = dot(p, p);
    float axis = (1.0 - s) / (1.0 + s);
    return float3(2.0 * p / (1.0 + s), face == DP_FRONT ? -axis : axis);
}

// DPWeight: how much of the sphere a texel stands for, over what the middle one does: the share of it inside of the disc
// times 1 / (1 + rho^2)^2. Over both faces the weights add up to the sphere, within 0.2 % for 64 texels a side.
//
//   uv          of the texel's centre
//   sideTexels  of a face
float DPWeight(float2 uv, int sideTexels)
{
    float2 p = DPUvToDisc(uv);
    float s = dot(p, p);
    float inside = saturate(0.5 + 0.5 * sideTexels * (1.0 - sqrt(s)));
    return inside / ((1.0 + s) * (1.0 + s));
}

// DPSample: light from one direction. The paper's texDP, which added both faces under a mask; one sample is enough,
// because faces hold what lies just beyond their discs too.
//
//   front, back  the faces; colour not times alpha
//   linearClamp  the sampler
//   dir          length 1
//
// Cost: 1 sample.
float4 DPSample(Texture2D<float4> front, Texture2D<float4> back, SamplerState linearClamp, float3 dir)
{
    float2 uv = DPDirectionToUv(dir, DPFaceOf(dir));
    float4 colour;
    if (DPFaceOf(dir) == DP_FRONT)
        colour = front.SampleLevel(linearClamp, uv, 0.0);
    else
        colour = back.SampleLevel(linearClamp, uv, 0.0);
    return colour;
}

// A circle on a face, in the disc's units.
struct DPCircle
{
    float2 centre;
    float radius;
};

// DPCircleOf: a cone of directions on a face. The circle of an angle t round a direction at the angle a from the axis has
// its centre at sin a / (cos t + cos a) and the radius sin t / (cos t + cos a).
//
//   dir           length 1
//   radiusAtPole  tan(t / 2): the radius that it has at the axis; over 0.414 (t = 45 degrees) is taken as that, so that no
//                 cone that reaches this face comes near the axis of the other one
//   returns       a circle that is not seen where a - t is 90 degrees or more, or within 0.1 degrees of that: there, for the
//                 widest cones, it has no end
DPCircle DPCircleOf(float3 dir, int face, float radiusAtPole)
{
    float r = min(radiusAtPole, kDPLargestRadius);
    float cosT = (1.0 - r * r) / (1.0 + r * r);
    float sinT = 2.0 * r / (1.0 + r * r);
    float cosA = DPAxisCosine(dir, face);
    bool isSeen = cosA > -sinT + 2e-3;
    float denominator = max(cosT + cosA, 1e-4);
    DPCircle circle;
    circle.centre = dir.xy / denominator;
    circle.radius = sinT / denominator;
    if (!isSeen)
    {
        circle.centre = float2(2.0, 0.0);
        circle.radius = 0.0;
    }
    return circle;
}

// DPIsSeen: whether any of a circle lies on its face's disc: else its face need not be read.
bool DPIsSeen(DPCircle circle)
{
    return length(circle.centre) < 1.0 + circle.radius;
}

// DPBoxOf: the box round that part of a circle which lies on its face's disc, in edge coordinates of the picture. Empty
// where none does. A box round all of the circle would reach far into the disc with its corner when the circle only
// touches the rim.
//
//   sideTexels  of a face
SATBox DPBoxOf(DPCircle circle, int sideTexels)
{
    float2 lo = circle.centre - circle.radius;
    float2 hi = circle.centre + circle.radius;
    float fromMiddle = length(circle.centre);
    if (fromMiddle >= 1.0 + circle.radius)
        hi = lo;
    else if (fromMiddle > abs(1.0 - circle.radius))
    {
        // Where the circle cuts the rim; then the ends of either that lie in the other.
        float2 towards = circle.centre / fromMiddle;
        float along = (1.0 + (fromMiddle - circle.radius) * (fromMiddle + circle.radius)) / (2.0 * fromMiddle);
        float across = sqrt(max(0.0, 1.0 - along * along));
        float2 a = along * towards + across * float2(-towards.y, towards.x);
        float2 b = along * towards - across * float2(-towards.y, towards.x);
        float2 lensLo = min(a, b), lensHi = max(a, b);
        for (int i = 0; i < 4; i++)
        {
            float2 outward = float2(i == 0 ? 1.0 : i == 1 ? -1.0 : 0.0, i == 2 ? 1.0 : i == 3 ? -1.0 : 0.0);
            float2 end = circle.centre + circle.radius * outward;
            float2 p = a, q = a;
            if (dot(end, end) <= 1.0)
                p = end;
            if (length(outward - circle.centre) <= circle.radius)
                q = outward;
            lensLo = min(lensLo, min(p, q));
            lensHi = max(lensHi, max(p, q));
        }
        lo = lensLo;
        hi = lensHi;
    }
    else if (circle.radius > 1.0)
    {
        lo = float2(-1.0, -1.0);
        hi = float2(1.0, 1.0);
    }
    SATBox box;
    box.loTexels = DPDiscToUv(float2(lo.x, hi.y)) * sideTexels;
    box.hiTexels = DPDiscToUv(float2(hi.x, lo.y)) * sideTexels;
    return box;
}

#endif
