#include "runtime/passes/meta_mipmap.h"

#include <bit>

#include "tools/base/error.h"

namespace boxcar {

MetaMipmap::MetaMipmap(Device& device, Extent2D extent)
    : m_levels(device, {.extent = extent, .name = "meta-mipmap", .levels = MipLevels(extent)}) {
    CommandList commands(device);
    std::vector<Image> levels;  // the device fills one until all is done
    for (uint32_t level = 0; level < MipLevels(extent); level++) {
        const auto [width, height] = LevelExtent(extent, level);
        const Image& texels = levels.emplace_back(device, ImageDesc{.extent = {width, height}, .name = "meta level"});
        commands.Clear(texels,
                       {1 / static_cast<float>(width), 1 / static_cast<float>(height), static_cast<float>(level), 0});
        commands.Copy(texels, m_levels, 0, level);
    }
    commands.Use(m_levels, ImageUse::ShaderRead);
    commands.SubmitAndWait();
}

uint32_t MetaBaseLevel(uint32_t widthTexels, Extent2D texture) {
    BOXCAR_ASSERT(std::has_single_bit(widthTexels));
    const uint32_t levels = MipLevels({widthTexels, 1}), needed = MipLevels(texture);
    if (needed > levels)
        throw Error("a meta-mipmap of {} texels for a texture of {} x {}: it serves textures up to its own size",
                    widthTexels, texture.widthTexels, texture.heightTexels);
    return levels - needed;
}

}  // namespace boxcar
