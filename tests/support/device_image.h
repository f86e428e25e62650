// Images between tests and device.
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <random>
#include <vector>

#include "runtime/command_list.h"
#include "runtime/transfer.h"
#include "tests/reference/box.h"
#include "tests/support/test_device.h"

namespace boxcar {

using Texels = std::vector<glm::vec4>;

inline Image Upload(Extent2D extent, const Texels& texels, const std::string& name = "test source") {
    Image image(TestDevice(), {extent, Format::RGBA32F, name});
    WriteTexels(TestDevice(), image, std::as_bytes(std::span(texels)));
    return image;
}

inline Texels Download(const Image& image) {
    Texels texels(image.Extent().Texels());
    ReadTexels(TestDevice(), image, std::as_writable_bytes(std::span(texels)));
    return texels;
}

// Uploads, records, runs, reads back.
inline Texels RunOnDevice(Extent2D extent, const Texels& source,
                          const std::function<const Image&(CommandList&, const Image&)>& record) {
    const Image image = Upload(extent, source);
    CommandList commands(TestDevice());
    const Image& result = record(commands, image);
    commands.SubmitAndWait();
    return Download(result);
}

// Noise in whole codes 0..255: sums of up to 65,793 of them are exact in float32.
inline Texels RandomCodes(Extent2D extent, uint32_t seed) {
    std::mt19937 random(seed);
    Texels texels(extent.Texels());
    for (glm::vec4& texel : texels)
        for (int c = 0; c < 4; c++)
            texel[c] = static_cast<float>(random() % 256);
    return texels;
}

// Noise in [0, 1) with full mantissas.
inline Texels RandomValues(Extent2D extent, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    Texels texels(extent.Texels());
    for (glm::vec4& texel : texels)
        for (int c = 0; c < 4; c++)
            texel[c] = unit(random);
    return texels;
}

inline reference::DoubleImage ToDouble(Extent2D extent, const Texels& texels) {
    return {
        static_cast<int>(extent.widthTexels), static_cast<int>(extent.heightTexels), {texels.begin(), texels.end()}};
}

}  // namespace boxcar
