// Texels to the device and back, as vectors.
#pragma once

#include <glm/ext/vector_uint4.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "runtime/command_list.h"
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

template <typename Texel>
std::vector<Texel> Download(Device& device, const Image& image) {
    std::vector<Texel> texels(image.Extent().Texels());
    ReadTexels(device, image, std::as_writable_bytes(std::span(texels)));
    return texels;
}

}  // namespace boxcar
