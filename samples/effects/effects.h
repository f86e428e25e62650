// The rows of the table of effects: each stands in the file of its effect.
#pragma once

#include "samples/effects/effect.h"

namespace boxcar {

EffectInfo GlossyEnvironmentInfo();
EffectInfo PhongEnvironmentInfo();
EffectInfo ParaboloidDirectInfo();
EffectInfo PlanarReflectionInfo();
EffectInfo TranslucencyInfo();
EffectInfo SoftShadowInfo();
EffectInfo TextureFilteringInfo();
EffectInfo DepthOfFieldInfo();
EffectInfo IsosurfaceInfo();

}  // namespace boxcar
