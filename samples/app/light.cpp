#include "samples/app/light.h"

#include <algorithm>
#include <cmath>

#include "samples/files/color.h"
#include "tools/base/error.h"

namespace boxcar {

namespace {

std::vector<glm::vec4> TexelsOf(const Picture& picture) {
    const int channels = static_cast<int>(picture.channels);
    std::vector<glm::vec4> texels(size_t{picture.widthTexels} * picture.heightTexels);
    const float* sample = picture.samples.data();
    for (glm::vec4& texel : texels)
        for (int c = 0; c < channels; c++)
            texel[c] = *sample++;
    return texels;
}

}  // namespace

std::vector<glm::vec4> ToLight(const Picture& picture, Transfer transfer) {
    if (transfer == Transfer::Raw || picture.stored == SampleType::Float32) return TexelsOf(picture);
    Picture light = picture;
    DecodeSrgb(light);
    Premultiply(light);
    return TexelsOf(light);
}

Picture FromLight(const std::vector<glm::vec4>& texels, const Picture& like, Transfer transfer,
                  SampleType sampleType) {
    Picture picture{like.widthTexels, like.heightTexels, like.channels, sampleType, {}, like.colorSpace};
    if (transfer == Transfer::Srgb) picture.colorSpace.gamma = 0;
    picture.samples.reserve(texels.size() * like.channels);
    const int channels = static_cast<int>(picture.channels);
    // Integer files mark what is not a number: magenta, or white where there is no color; opaque.
    const bool marksInColor = sampleType != SampleType::Float32;
    for (const glm::vec4& texel : texels) {
        const bool isMarked = marksInColor && !IsFinite(texel);
        for (int c = 0; c < channels; c++)
            picture.samples.push_back(isMarked ? (c == 1 && channels > 2 ? 0.0f : 1.0f) : texel[c]);
    }
    if (transfer == Transfer::Srgb && sampleType != SampleType::Float32) {
        Unpremultiply(picture);
        EncodeSrgb(picture);
    }
    return picture;
}

bool IsFinite(const glm::vec4& texel) {
    return std::isfinite(texel.x) && std::isfinite(texel.y) && std::isfinite(texel.z) && std::isfinite(texel.w);
}

void RequireFiniteSums(const std::vector<glm::vec4>& texels, const std::string& name) {
    if (!std::ranges::all_of(texels, IsFinite))
        throw Error("{}: its sums are beyond float32's largest number; scale its samples down", name);
}

}  // namespace boxcar
