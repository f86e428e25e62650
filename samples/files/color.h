// Arithmetic on the samples of a picture between file and filter. Alpha is never put through a curve.
#pragma once

#include <cstdint>
#include <optional>

#include "samples/files/picture.h"

namespace boxcar {

// The piecewise sRGB curve and its inverse; below 0 they are lines, above 1 they go on as they are.
//
// IEC 61966-2-1:1999, sect. 5.2
double SrgbToLinear(double encoded);
double LinearToSrgb(double linear);

// The linear light of a code in [0,1]: by the gamma of `space`, or the sRGB curve where it has none.
double ToLinear(const ColorSpace& space, double encoded);

// ToLinear and the sRGB curve over every color sample: in double, rounded once to float.
void DecodeSrgb(Picture& picture);
void EncodeSrgb(Picture& picture);

// Colors times alpha, and back; without alpha nothing is done. Where alpha is 0 or less, Unpremultiply makes the
// colors 0.
void Premultiply(Picture& picture);
void Unpremultiply(Picture& picture);

struct TexelPosition {
    uint32_t x = 0;
    uint32_t y = 0;
};

// The first texel, row by row, with a NaN or an infinity.
std::optional<TexelPosition> FirstNotFinite(const Picture& picture);

// Makes every NaN and infinity 0.
void ZeroNotFinite(Picture& picture);

}  // namespace boxcar
