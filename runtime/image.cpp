#include "runtime/image.h"

#include <algorithm>
#include <bit>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

std::string Size(Extent2D extent) {
    return fmt::format("{} x {}", extent.widthTexels, extent.heightTexels);
}

std::string Size(const ImageDesc& desc) {
    return Size(desc.extent) + (desc.IsVolume() ? fmt::format(" x {}", desc.depthTexels) : "");
}

double MiB(uint64_t bytes) {
    return static_cast<double>(bytes) / (1 << 20);
}

void RequireFits(const ImageDesc& desc, uint64_t bytes, const DeviceLimits& limits) {
    if (bytes > limits.maxImageBytes)
        throw Error("image '{}' of {} texels ({}) takes {:.0f} MiB: the device gives one image at most {:.0f} MiB",
                    desc.name, Size(desc), FormatName(desc.format), MiB(bytes), MiB(limits.maxImageBytes));
}

vk::ImageUsageFlags Usage(const Device::Impl& device, Format format) {
    using Feature = vk::FormatFeatureFlagBits;
    using Use = vk::ImageUsageFlagBits;
    const auto features = device.physicalDevice.getFormatProperties(VulkanFormat(format)).optimalTilingFeatures;
    vk::ImageUsageFlags usage = Use::eTransferSrc | Use::eTransferDst;
    if (features & Feature::eSampledImage) usage |= Use::eSampled;
    if (features & Feature::eStorageImage) usage |= Use::eStorage;
    if (features & Feature::eColorAttachment) usage |= Use::eColorAttachment;
    if (features & Feature::eDepthStencilAttachment) usage |= Use::eDepthStencilAttachment;
    return usage;
}

uint64_t Bytes(const ImageDesc& desc) {
    uint64_t texels = 0;
    for (uint32_t level = 0; level < desc.levels; level++)
        texels += LevelExtent(desc.extent, level).Texels();
    return texels * desc.layers * std::max(desc.depthTexels, 1u) * BytesPerTexel(desc.format);
}

}  // namespace

uint32_t MipLevels(Extent2D extent) {
    return static_cast<uint32_t>(std::bit_width(std::max(extent.widthTexels, extent.heightTexels)));
}

Extent2D LevelExtent(Extent2D extent, uint32_t level) {
    return {std::max(extent.widthTexels >> level, 1u), std::max(extent.heightTexels >> level, 1u)};
}

Image::Image(Device& device, const ImageDesc& desc) : m_impl(new Impl) {
    Impl& i = *m_impl;
    i.device = &device.impl();
    i.desc = desc;
    const auto [width, height] = desc.extent;
    const DeviceLimits& limits = device.Limits();
    if (width == 0 || height == 0)
        throw Error("image '{}' of {} texels: both sides must be at least 1", desc.name, Size(desc));
    const uint32_t maxSide = desc.IsVolume() ? limits.maxVolumeSideTexels : limits.maxSideTexels;
    if (std::max({width, height, desc.depthTexels}) > maxSide)
        throw Error("image '{}' of {} texels: the device takes at most {} a side", desc.name, Size(desc), maxSide);
    BOXCAR_ASSERT(!desc.IsVolume() || (desc.layers == 1 && desc.levels == 1));
    if (desc.layers != 1 && (desc.layers != 6 || width != height))
        throw Error("image '{}' of {} texels with {} layers: 1, or 6 squares of a cube map", desc.name,
                    Size(desc.extent), desc.layers);
    if (desc.levels < 1 || desc.levels > MipLevels(desc.extent))
        throw Error("image '{}' of {} texels with {} levels: it has 1 to {}", desc.name, Size(desc.extent),
                    desc.levels, MipLevels(desc.extent));
    RequireFits(desc, Bytes(desc), limits);

    vk::ImageCreateInfo info;
    info.imageType = desc.IsVolume() ? vk::ImageType::e3D : vk::ImageType::e2D;
    info.format = VulkanFormat(desc.format);
    info.extent = vk::Extent3D(width, height, std::max(desc.depthTexels, 1u));
    info.mipLevels = desc.levels;
    info.arrayLayers = desc.layers;
    if (desc.layers == 6) info.flags = vk::ImageCreateFlagBits::eCubeCompatible;
    info.usage = Usage(*i.device, desc.format);
    i.ownImage = vk::raii::Image(i.device->device, info);
    i.image = *i.ownImage;

    const vk::MemoryRequirements needs = i.ownImage.getMemoryRequirements();
    RequireFits(desc, needs.size, limits);
    auto type = i.device->MemoryType(needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
    if (!type) type = i.device->MemoryType(needs.memoryTypeBits, {});
    try {
        i.memory = vk::raii::DeviceMemory(i.device->device, vk::MemoryAllocateInfo(needs.size, *type));
    } catch (const vk::SystemError& error) {
        throw Error(
            "image '{}' of {} texels ({}) takes {:.0f} MiB: the device, which holds {:.0f} MiB already, has no "
            "more ({})",
            desc.name, Size(desc), FormatName(desc.format), MiB(needs.size), MiB(i.device->memoryBytes),
            error.what());
    }
    i.ownImage.bindMemory(*i.memory, 0);

    vk::ImageViewCreateInfo viewInfo;
    viewInfo.image = i.image;
    viewInfo.viewType = desc.IsVolume()    ? vk::ImageViewType::e3D
                        : desc.layers == 6 ? vk::ImageViewType::eCube
                                           : vk::ImageViewType::e2D;
    viewInfo.format = info.format;
    viewInfo.subresourceRange = vk::ImageSubresourceRange(AspectOf(desc.format), 0, desc.levels, 0, desc.layers);
    i.ownView = vk::raii::ImageView(i.device->device, viewInfo);
    i.view = *i.ownView;

    i.device->Name(i.ownImage, desc.name);
    i.device->Name(i.ownView, desc.name);
    i.device->Name(i.memory, desc.name);
    i.memoryBytes = needs.size;
    i.device->CountMemory(static_cast<int64_t>(i.memoryBytes));
}

Image::Image(Device& device, const ImageDesc& desc, const WrappedImage& wrapped) : m_impl(new Impl) {
    Impl& i = *m_impl;
    i.device = &device.impl();
    i.desc = desc;
    i.image = wrapped.image;
    i.view = wrapped.view;
    i.state = {static_cast<vk::ImageLayout>(wrapped.layout), vk::PipelineStageFlags2(wrapped.lastStages),
               vk::AccessFlags2(wrapped.lastAccess)};
}

Image::~Image() {
    if (m_impl) m_impl->device->CountMemory(-static_cast<int64_t>(m_impl->memoryBytes));
}

Image::Image(Image&&) noexcept = default;

Image& Image::operator=(Image&& other) noexcept {
    std::swap(m_impl, other.m_impl);
    return *this;
}

const ImageDesc& Image::Desc() const {
    return m_impl->desc;
}
VkImage Image::Handle() const {
    return m_impl->image;
}
VkImageView Image::View() const {
    return m_impl->view;
}

}  // namespace boxcar
