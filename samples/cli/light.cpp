#include "samples/cli/light.h"

#include <cmath>

#include "samples/files/color.h"

namespace boxcar {

std::vector<glm::vec4> ToLight(Picture picture, Transfer transfer) {
    if (transfer == Transfer::Srgb && picture.stored != SampleType::Float32) {
        DecodeSrgb(picture);
        Premultiply(picture);
    }
    const int channels = static_cast<int>(picture.channels);
    std::vector<glm::vec4> texels(size_t{picture.widthTexels} * picture.heightTexels);
    const float* sample = picture.samples.data();
    for (glm::vec4& texel : texels)
        for (int c = 0; c < channels; c++)
            texel[c] = *sample++;
    return texels;
}

Picture FromLight(const std::vector<glm::vec4>& texels, const Picture& like, Transfer transfer,
                  SampleType sampleType) {
    Picture picture{like.widthTexels, like.heightTexels, like.channels, sampleType, {}};
    picture.samples.reserve(texels.size() * like.channels);
    const int channels = static_cast<int>(picture.channels);
    // In an integer file, magenta marks what is not a number: (1, 0, 1, 1).
    const bool marksInColour = sampleType != SampleType::Float32;
    for (const glm::vec4& texel : texels) {
        const bool isMarked = marksInColour && std::isnan(texel.x);
        for (int c = 0; c < channels; c++)
            picture.samples.push_back(isMarked ? (c == 1 && channels > 2 ? 0.0f : 1.0f) : texel[c]);
    }
    if (transfer == Transfer::Srgb && sampleType != SampleType::Float32) {
        Unpremultiply(picture);
        EncodeSrgb(picture);
    }
    return picture;
}

}  // namespace boxcar
