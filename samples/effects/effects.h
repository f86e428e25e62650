// The rows of the table of effects: each stands in the file of its effect.
#pragma once

#include "samples/effects/effect.h"

namespace boxcar {

EffectInfo PlanarReflectionInfo();
EffectInfo TextureFilteringInfo();
EffectInfo SoftShadowInfo();

}  // namespace boxcar
