// The little that is asked of ICC profiles, which are otherwise handed on as they are.
#pragma once

#include <optional>

#include "samples/files/bytes.h"

namespace boxcar {

// The light, of 1, that a code of one half stands for by the profile's curve for red, or for gray. nullopt: it has
// none, as where it is made of tables of colors, or it is damaged.
std::optional<double> LightOfHalf(ByteView profile);

// Whether its curve is about sRGB's and its primaries, if it is not for gray, are.
bool IsSrgbProfile(ByteView profile);

// Whether `light`, of LightOfHalf, is about that of the sRGB curve (a gamma of 2.2 is).
bool IsLightOfSrgbHalf(double light);

}  // namespace boxcar
