// dp_encode.ps: a face as the whole numbers that an exact table sums: light times weight in rgb, the weight in alpha, as
// one and the same code in both, so that a constant stays constant. FINE: what rounding left over of the light, 0 in
// alpha.
#include "boxcar/compat.hlsli"
#include "boxcar/dual_paraboloid_range.h"
#include "boxcar/texel.hlsli"
#include "constants/dp_constants.h"
#include "shaders/quad_io.hlsli"
#define WORDS 2
#include "shaders/words_io.hlsli"

BOXCAR_CONSTANTS(Constants) { DPFaceConstants g; };
Texture2D<float4> face : register(t0);

WordsTarget main(QuadVertex i)
{
    float4 texel = face.Load(int3(TexelFromEdge(i.position.xy), 0));
    float weight = floor(4096.0 * texel.a + 0.5);
    float3 light = clamp(texel.rgb, 0.0, g.largestLight);
    float4 code = float4(light * (weight * g.codeScale), weight);
#if FINE
    float4 rest = (code - floor(code + 0.5)) * kDPFineScale;
    return WordsTargetOf(SATWideSub(SATWideFromFloat(max(rest, 0.0)), SATWideFromFloat(max(-rest, 0.0))));
#else
    return WordsTargetOf(SATWideFromFloat(code));
#endif
}
