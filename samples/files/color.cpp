#include "samples/files/color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace boxcar {
namespace {

template <typename Curve>
void ApplyToColors(Picture& picture, Curve curve) {
    const size_t colors = picture.channels - (HasAlpha(picture) ? 1 : 0);
    for (size_t texel = 0; texel < picture.samples.size(); texel += picture.channels)
        for (size_t i = texel; i < texel + colors; ++i)
            picture.samples[i] = static_cast<float>(curve(picture.samples[i]));
}

template <typename Factor>
void ScaleColors(Picture& picture, Factor factorOfAlpha) {
    if (!HasAlpha(picture)) return;
    const size_t colors = picture.channels - 1;
    for (size_t texel = 0; texel < picture.samples.size(); texel += picture.channels) {
        const float alpha = picture.samples[texel + colors];
        for (size_t i = texel; i < texel + colors; ++i)
            picture.samples[i] = factorOfAlpha(picture.samples[i], alpha);
    }
}

}  // namespace

double SrgbToLinear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double LinearToSrgb(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double ToLinear(const ColorSpace& space, double encoded) {
    return space.gamma == 0.0 ? SrgbToLinear(encoded) : std::pow(std::max(encoded, 0.0), 1.0 / space.gamma);
}

void DecodeSrgb(Picture& picture) {
    ApplyToColors(picture, [&](double encoded) { return ToLinear(picture.colorSpace, encoded); });
}
void EncodeSrgb(Picture& picture) {
    ApplyToColors(picture, LinearToSrgb);
}

void Premultiply(Picture& picture) {
    ScaleColors(picture, [](float color, float alpha) { return color * alpha; });
}

void Unpremultiply(Picture& picture) {
    ScaleColors(picture, [](float color, float alpha) { return alpha > 0.0f ? color / alpha : 0.0f; });
}

std::optional<TexelPosition> FirstNotFinite(const Picture& picture) {
    const auto found = std::find_if_not(picture.samples.begin(), picture.samples.end(),
                                        [](float sample) { return std::isfinite(sample); });
    if (found == picture.samples.end()) return std::nullopt;
    const auto texel = static_cast<size_t>(found - picture.samples.begin()) / picture.channels;
    return TexelPosition{static_cast<uint32_t>(texel % picture.widthTexels),
                         static_cast<uint32_t>(texel / picture.widthTexels)};
}

void ZeroNotFinite(Picture& picture) {
    std::replace_if(
        picture.samples.begin(), picture.samples.end(), [](float s) { return !std::isfinite(s); }, 0.0f);
}

}  // namespace boxcar
