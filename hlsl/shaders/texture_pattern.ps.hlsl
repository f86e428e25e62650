// texture_pattern.ps: stripes or checks of black and white, to be mapped onto things.
#include "boxcar/compat.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"

BOXCAR_CONSTANTS(Constants) { TexturePatternConstants g; };

float4 main(QuadVertex i) : SV_Target0
{
    int2 cell = int2(floor(i.uv * g.cells));
    float light = float((cell.x + cell.y) & 1);
    return float4(light, light, light, 1.0);
}
