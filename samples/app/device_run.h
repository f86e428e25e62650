// Texels to the device and back, as vectors.
#pragma once

#include <glm/ext/vector_uint4.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "runtime/command_list.h"
#include "runtime/passes/texel_words.h"
#include "runtime/transfer.h"

namespace boxcar {

// `Texel`: glm::vec4 for RGBA32F, glm::uvec4 for RGBA32UI. Rows from the top.
template <typename Texel>
Image Upload(Device& device, Extent2D extent, std::span<const Texel> texels, const std::string& name) {
    constexpr Format kFormat = std::is_same_v<Texel, glm::vec4> ? Format::RGBA32F : Format::RGBA32UI;
    Image image(device, {extent, kFormat, name});
    WriteTexels(device, image, std::as_bytes(texels));
    return image;
}

// What a summed-area table is made of, with the images that hold it: one, or the lower and the upper words.
struct UploadedWords {
    std::vector<Image> images;

    operator TexelWords() const {
        return images.size() > 1 ? TexelWords(images[0], images[1]) : TexelWords(images[0]);
    }
};

template <typename Texel>
std::vector<Texel> Download(Device& device, const Image& image) {
    std::vector<Texel> texels(image.Extent().Texels());
    ReadTexels(device, image, std::as_writable_bytes(std::span(texels)));
    return texels;
}

}  // namespace boxcar
