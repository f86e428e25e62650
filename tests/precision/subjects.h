// Pictures to measure, and tables of the laboratory on the test device.
#pragma once

#include "samples/cli/precision/measure.h"
#include "samples/files/picture.h"
#include "tests/support/device_image.h"

namespace boxcar {

inline Subject SubjectOf(Extent2D extent, Texels texels, uint32_t largestCode = 255) {
    return {extent, std::move(texels), 3, largestCode, largestCode > 0};
}

// 8-bit codes / 255, uniform in [low, high].
inline Subject Noise(Extent2D extent, uint32_t seed, uint32_t low = 0, uint32_t high = 255) {
    std::mt19937 random(seed);
    Texels texels(extent.Texels());
    for (glm::vec4& texel : texels)
        for (int c = 0; c < 4; c++)
            texel[c] = static_cast<float>(low + random() % (high - low + 1)) / 255.0f;
    return SubjectOf(extent, std::move(texels));
}

// Squares of `squareTexels`, `dark` and `bright` codes in turn.
inline Subject Checkerboard(Extent2D extent, uint32_t squareTexels, uint32_t dark, uint32_t bright) {
    Texels texels;
    for (uint32_t y = 0; y < extent.heightTexels; y++)
        for (uint32_t x = 0; x < extent.widthTexels; x++)
            texels.emplace_back(static_cast<float>((x / squareTexels + y / squareTexels) % 2 == 0 ? dark : bright) /
                                255.0f);
    return SubjectOf(extent, std::move(texels));
}

inline Subject Constant(Extent2D extent, uint32_t code) {
    return SubjectOf(extent, Texels(extent.Texels(), glm::vec4(static_cast<float>(code) / 255.0f)));
}

// A rectangle of a photograph's 8-bit codes; {} is all of it.
inline Subject Photograph(const std::string& name, Rect crop = {}) {
    const Picture picture = ReadPicture(std::string(BOXCAR_ASSETS "/") + name);
    if (crop.widthTexels == 0) crop = {0, 0, picture.widthTexels, picture.heightTexels};
    Texels texels;
    for (uint32_t y = crop.yTexels; y < crop.yTexels + crop.heightTexels; y++)
        for (uint32_t x = crop.xTexels; x < crop.xTexels + crop.widthTexels; x++) {
            const float* rgb = &picture.samples[3 * (size_t{y} * picture.widthTexels + x)];
            texels.emplace_back(rgb[0], rgb[1], rgb[2], 1);
        }
    return SubjectOf({crop.widthTexels, crop.heightTexels}, std::move(texels));
}

// A table read back; RGBA32F only.
inline Texels TableOf(const Subject& subject, const TableSetup& setup) {
    PrecisionTable table(TestDevice(), subject.extent);
    const Image source = Upload(subject.extent, subject.texels);
    CommandList commands(TestDevice());
    const Image& result = table.Record(commands, source, setup);
    commands.SubmitAndWait();
    return Download(result);
}

}  // namespace boxcar
