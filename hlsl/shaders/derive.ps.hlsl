// derive.ps: a derivative of a picture at its texels, under the cubic B-spline. WHAT is DX, DY, DXX, DXY, DYY, GRADIENT or
// CURVATURE.
// Sigg 2005, sect. 20.4 and 20.5
#include "boxcar/bspline_gradient.hlsli"
#include "shaders/quad_io.hlsli"

#define DX 0
#define DY 1
#define DXX 2
#define DXY 3
#define DYY 4
#define GRADIENT 5
#define CURVATURE 6

Texture2D<float4> source : register(t0);

float4 main(QuadVertex i) : SV_Target0
{
    int2 extentTexels;
    source.GetDimensions(extentTexels.x, extentTexels.y);
    BSplineDerivatives2D d = BSplineDerivativesLoad2D(source, extentTexels, i.position.xy);
#if WHAT == DX
    return d.dx;
#elif WHAT == DY
    return d.dy;
#elif WHAT == DXX
    return d.dxx;
#elif WHAT == DXY
    return d.dxy;
#elif WHAT == DYY
    return d.dyy;
#else
    float4 slope = sqrt(d.dx * d.dx + d.dy * d.dy);
#if WHAT == GRADIENT
    return slope;
#else
    // Of the line of equal value through the point; positive where it bends round what is brighter.
    float4 bend = d.dxx * d.dy * d.dy - 2.0 * d.dxy * d.dx * d.dy + d.dyy * d.dx * d.dx;
    float4 cube = max(slope * slope * slope, 1e-12);
    return -bend / cube;
#endif
#endif
}
