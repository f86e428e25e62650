#include <algorithm>
#include <array>

#include "runtime/vulkan.h"

namespace boxcar {
namespace {

struct FilterRow {
    const char* name;
    vk::Filter filter;
    vk::SamplerMipmapMode mips;
    float maxAnisotropy;
};

constexpr FilterRow kFilters[] = {{"nearest", vk::Filter::eNearest, vk::SamplerMipmapMode::eNearest, 1},
                                  {"linear", vk::Filter::eLinear, vk::SamplerMipmapMode::eLinear, 1},
                                  {"anisotropic", vk::Filter::eLinear, vk::SamplerMipmapMode::eLinear, 16}};
constexpr std::array kAddressModes = {std::pair{"Border", vk::SamplerAddressMode::eClampToBorder},
                                      std::pair{"Clamp", vk::SamplerAddressMode::eClampToEdge},
                                      std::pair{"Repeat", vk::SamplerAddressMode::eRepeat},
                                      std::pair{"Mirror", vk::SamplerAddressMode::eMirroredRepeat}};

}  // namespace

const vk::raii::Sampler* Device::Impl::FindSampler(std::string_view name) {
    if (const auto found = samplers.find(name); found != samplers.end()) return &found->second;
    for (const FilterRow& row : kFilters) {
        for (const auto& [modeName, mode] : kAddressModes) {
            if (name != std::string(row.name) + modeName) continue;
            vk::SamplerCreateInfo sampler;
            sampler.magFilter = sampler.minFilter = row.filter;
            sampler.mipmapMode = row.mips;
            sampler.maxAnisotropy = std::min(row.maxAnisotropy, maxAnisotropy);
            sampler.anisotropyEnable = sampler.maxAnisotropy > 1;
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
