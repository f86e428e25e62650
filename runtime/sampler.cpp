#include <array>

#include "runtime/vulkan.h"

namespace boxcar {
namespace {

constexpr std::array kFilters = {std::pair{"nearest", vk::Filter::eNearest},
                                 std::pair{"linear", vk::Filter::eLinear}};
constexpr std::array kAddressModes = {std::pair{"Border", vk::SamplerAddressMode::eClampToBorder},
                                      std::pair{"Clamp", vk::SamplerAddressMode::eClampToEdge},
                                      std::pair{"Repeat", vk::SamplerAddressMode::eRepeat},
                                      std::pair{"Mirror", vk::SamplerAddressMode::eMirroredRepeat}};

}  // namespace

const vk::raii::Sampler* Device::Impl::FindSampler(std::string_view name) {
    if (const auto found = samplers.find(name); found != samplers.end()) return &found->second;
    for (const auto& [filterName, filter] : kFilters) {
        for (const auto& [modeName, mode] : kAddressModes) {
            if (name != std::string(filterName) + modeName) continue;
            vk::SamplerCreateInfo sampler;
            sampler.magFilter = sampler.minFilter = filter;
            sampler.mipmapMode = vk::SamplerMipmapMode::eNearest;
            sampler.addressModeU = sampler.addressModeV = sampler.addressModeW = mode;
            sampler.borderColor = vk::BorderColor::eFloatTransparentBlack;
            sampler.maxLod = VK_LOD_CLAMP_NONE;
            const auto [at, added] = samplers.emplace(std::string(name), vk::raii::Sampler(device, sampler));
            Name(at->second, at->first);
            return &at->second;
        }
    }
    return nullptr;
}

}  // namespace boxcar
