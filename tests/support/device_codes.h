// Whole codes between tests and device.
#pragma once

#include <glm/ext/vector_uint4.hpp>
#include <vector>

#include "runtime/passes/sat_filter.h"
#include "tests/reference/exact.h"
#include "tests/support/device_image.h"

namespace boxcar {

inline Image UploadWords(Extent2D extent, const std::vector<glm::uvec4>& texels) {
    Image image(TestDevice(), {extent, Format::RGBA32UI, "test codes"});
    WriteTexels(TestDevice(), image, std::as_bytes(std::span(texels)));
    return image;
}

inline std::vector<glm::uvec4> DownloadWords(const Image& image) {
    std::vector<glm::uvec4> texels(image.Extent().Texels());
    ReadTexels(TestDevice(), image, std::as_writable_bytes(std::span(texels)));
    return texels;
}

// Codes on the device, in as many words as the precision has.
struct DeviceCodes {
    DeviceCodes(const reference::CodeImage& image, SATPrecision precision) {
        const Extent2D extent{static_cast<uint32_t>(image.width), static_cast<uint32_t>(image.height)};
        for (uint32_t word = 0; word < WordsOf(precision); word++) {
            std::vector<glm::uvec4> texels;
            for (const auto& texel : image.texels)
                texels.emplace_back(
                    static_cast<uint32_t>(texel[0] >> (32 * word)), static_cast<uint32_t>(texel[1] >> (32 * word)),
                    static_cast<uint32_t>(texel[2] >> (32 * word)), static_cast<uint32_t>(texel[3] >> (32 * word)));
            images.push_back(UploadWords(extent, texels));
        }
    }

    TexelWords Words() const { return images.size() > 1 ? TexelWords(images[0], images[1]) : TexelWords(images[0]); }

    std::vector<Image> images;
};

// Codes from `smallest` to `largest`.
inline reference::CodeImage RandomCodeImage(Extent2D extent, uint32_t seed, int64_t smallest, int64_t largest) {
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int64_t> code(smallest, largest);
    reference::CodeImage image{static_cast<int>(extent.widthTexels), static_cast<int>(extent.heightTexels), {}};
    for (uint64_t i = 0; i < extent.Texels(); i++)
        image.texels.push_back({code(random), code(random), code(random), code(random)});
    return image;
}

inline reference::DoubleImage ToDouble(const reference::CodeImage& image) {
    reference::DoubleImage result{image.width, image.height, {}};
    for (const auto& texel : image.texels)
        result.texels.emplace_back(texel[0], texel[1], texel[2], texel[3]);
    return result;
}

}  // namespace boxcar
