#include "runtime/format.h"

#include <glm/ext/vector_uint4.hpp>

#include "runtime/vulkan.h"

namespace boxcar {
namespace {

struct FormatRow {
    const char* name;
    uint32_t bytes;
    vk::Format vulkan;
};

const FormatRow& Row(Format format) {
    static const FormatRow kRows[] = {
        {"RGBA32F", 16, vk::Format::eR32G32B32A32Sfloat}, {"RGBA16F", 8, vk::Format::eR16G16B16A16Sfloat},
        {"RGBA8", 4, vk::Format::eR8G8B8A8Unorm},         {"R32F", 4, vk::Format::eR32Sfloat},
        {"RGBA32UI", 16, vk::Format::eR32G32B32A32Uint},  {"Depth32F", 4, vk::Format::eD32Sfloat},
    };
    return kRows[static_cast<size_t>(format)];
}

}  // namespace

uint32_t BytesPerTexel(Format format) {
    return Row(format).bytes;
}
const char* FormatName(Format format) {
    return Row(format).name;
}
vk::Format VulkanFormat(Format format) {
    return Row(format).vulkan;
}

vk::ClearColorValue ClearValue(const glm::vec4& rgba, Format format) {
    if (format == Format::RGBA32UI) {
        const glm::uvec4 words(rgba);
        return std::array{words.x, words.y, words.z, words.w};
    }
    return std::array{rgba.x, rgba.y, rgba.z, rgba.w};
}

}  // namespace boxcar
