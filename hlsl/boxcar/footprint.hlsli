// footprint.hlsli: how large a box a pixel, a gloss, a lens asks for.
#ifndef BOXCAR_FOOTPRINT_HLSLI
#define BOXCAR_FOOTPRINT_HLSLI

// FootprintRectangle: the upright rectangle of texture that a pixel covers.
//
//   ddxUv, ddyUv  how far the texture coordinate moves from one pixel to the next, across and down
//   returns       width and height, in uv: of the two movements the larger, for u and for v
//
// Their sum would hold the pixel's parallelogram; the larger one blurs less and aliases little (Crow 1984, sect. 3).
//
// Cost: 2 comparisons.
float2 FootprintRectangle(float2 ddxUv, float2 ddyUv)
{
    return max(abs(ddxUv), abs(ddyUv));
}

// FootprintLens: diameter of the circle of confusion of a thin lens, in texels.
//
//   disparity       of the point: 1 / distance, in any unit
//   focusDisparity  of what is in focus, in the same
//   apertureTexels  diameter for a disparity that differs by 1
//   returns         1 at least: what is in focus is one texel
//
// A lens of diameter A and focal length f, focused at z_f, spreads a point at z over A f / (z_f - f) |z - z_f| / z =
// A f z_f / (z_f - f) |1 / z_f - 1 / z|: linear in 1 / z, so one factor holds all of the lens.
//
// Cost: 3 operations. Hensley 2005, sect. 5.4
float FootprintLens(float disparity, float focusDisparity, float apertureTexels)
{
    return max(1.0, apertureTexels * abs(disparity - focusDisparity));
}

// FootprintCone: width of the cone that a glossy mirror spreads a ray into, as the picture of what it hits shows it.
//
//   rayDistance  from the mirror to what the ray hits
//   eyeDistance  from the eye to the mirror, in the same unit
//   coneTexels   width of a cone that is as wide as the ray is long, seen from the mirror itself
//   returns      1 at least
//
// The mirror image lies rayDistance behind the mirror, and is seen from eyeDistance + rayDistance away: sharp where
// things touch the mirror, and never wider than the cone itself.
//
// Cost: 4 operations. Hensley 2005, sect. 5.2
float FootprintCone(float rayDistance, float eyeDistance, float coneTexels)
{
    return max(1.0, coneTexels * rayDistance / (rayDistance + eyeDistance));
}

// FootprintPenumbra: width of a shadow's blurred rim, as the light sees it.
//
//   receiverDistance  from the light to what the shadow falls on
//   blockerDistance   from the light to what casts it, in the same unit; more than 0
//   lightTexels       width of the light, seen from one unit away, in texels of the light's picture
//   returns           1 at least: sharp where the two touch
//
// The rim of a light of width L is L (r - b) / b wide on the receiver, and the light sees it from r away.
//
// Cost: 4 operations. Green 2003 (blur by the distance from the occluder)
float FootprintPenumbra(float receiverDistance, float blockerDistance, float lightTexels)
{
    return max(1.0, lightTexels * (1.0 / blockerDistance - 1.0 / receiverDistance));
}

#endif
