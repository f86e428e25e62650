// bspline_prefilter.ps: along one axis, the coefficients whose cubic B-spline goes through the texels.
//
// The spline's values at texels are (c[i - 1] + 4 c[i] + c[i + 1]) / 6. The inverse of that is sqrt(3) z^|k| with
// z = sqrt(3) - 2 = -0.268: 14 texels away it is 1e-8. The picture goes on as its mirror image, and so do the coefficients.
//
// Beyond Sigg 2005
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/bspline_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { BSplinePrefilterConstants g; };
Texture2D<float4> source : register(t0);

static const int kReach = 14;

int Mirrored(int texel, int sizeTexels)
{
    int period = 2 * sizeTexels;
    int wrapped = texel - period * int(floor(float(texel) / float(period)));
    return wrapped < sizeTexels ? wrapped : period - 1 - wrapped;
}

float4 main(QuadVertex i) : SV_Target0
{
    int2 extentTexels;
    source.GetDimensions(extentTexels.x, extentTexels.y);
    int2 texel = TexelFromEdge(i.position.xy);
    float4 sum = source.Load(int3(texel, 0));
    float weight = 1.0;
    [loop]
    for (int k = 1; k <= kReach; k++)
    {
        weight *= -0.26794919;
        int2 lo = texel - k * g.stepTexels, hi = texel + k * g.stepTexels;
        sum += weight * (source.Load(int3(Mirrored(lo.x, extentTexels.x), Mirrored(lo.y, extentTexels.y), 0))
                       + source.Load(int3(Mirrored(hi.x, extentTexels.x), Mirrored(hi.y, extentTexels.y), 0)));
    }
    return 1.73205081 * sum;
}
