#include "runtime/base_level.h"

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {

Image FromBaseLevel(Device& device, const Image& image, uint32_t firstLevel) {
    const ImageDesc& all = image.Desc();
    const ImageState& state = image.impl().state;
    BOXCAR_ASSERT(all.layers == 1 && firstLevel < all.levels &&
                  state.layout == vk::ImageLayout::eShaderReadOnlyOptimal);
    Image coarser(device,
                  {.extent = LevelExtent(all.extent, firstLevel),
                   .format = all.format,
                   .name = all.name,
                   .levels = all.levels - firstLevel},
                  {.image = image.Handle()});
    Image::Impl& c = coarser.impl();
    c.state = state;
    c.ownView = vk::raii::ImageView(
        c.device->device, vk::ImageViewCreateInfo({}, c.image, vk::ImageViewType::e2D, VulkanFormat(all.format), {},
                                                  {AspectOf(all.format), firstLevel, c.desc.levels, 0, 1}));
    c.view = *c.ownView;
    c.device->Name(c.ownView, c.desc.name);
    return coarser;
}

}  // namespace boxcar
