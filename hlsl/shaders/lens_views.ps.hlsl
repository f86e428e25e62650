// lens_views.ps: adds eight views from points of a lens to those before.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"

Texture2D<float4> before : register(t0);
Texture2D<float4> view0 : register(t1);
Texture2D<float4> view1 : register(t2);
Texture2D<float4> view2 : register(t3);
Texture2D<float4> view3 : register(t4);
Texture2D<float4> view4 : register(t5);
Texture2D<float4> view5 : register(t6);
Texture2D<float4> view6 : register(t7);
Texture2D<float4> view7 : register(t8);

BOXCAR_CONSTANTS(Constants) { LensViewsConstants g; };

float4 main(QuadVertex i) : SV_Target0
{
    int3 at = int3(TexelFromEdge(i.position.xy), 0);
    float4 sum = view0.Load(at) + view1.Load(at) + view2.Load(at) + view3.Load(at)
               + view4.Load(at) + view5.Load(at) + view6.Load(at) + view7.Load(at);
    return before.Load(at) + g.share * sum;
}
