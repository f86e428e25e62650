#include "runtime/image.h"

#include "runtime/vulkan.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

std::string Size(Extent2D extent) {
    return fmt::format("{} x {}", extent.widthTexels, extent.heightTexels);
}

double MiB(uint64_t bytes) {
    return static_cast<double>(bytes) / (1 << 20);
}

void RequireFits(const ImageDesc& desc, uint64_t bytes, const DeviceLimits& limits) {
    if (bytes > limits.maxImageBytes)
        throw Error("image '{}' of {} texels ({}) takes {:.0f} MiB: the device gives one image at most {:.0f} MiB",
                    desc.name, Size(desc.extent), FormatName(desc.format), MiB(bytes), MiB(limits.maxImageBytes));
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

}  // namespace

Image::Image(Device& device, const ImageDesc& desc) : m_impl(new Impl) {
    Impl& i = *m_impl;
    i.device = &device.impl();
    i.desc = desc;
    const auto [width, height] = desc.extent;
    const DeviceLimits& limits = device.Limits();
    if (width == 0 || height == 0)
        throw Error("image '{}' of {} texels: both sides must be at least 1", desc.name, Size(desc.extent));
    if (width > limits.maxSideTexels || height > limits.maxSideTexels)
        throw Error("image '{}' of {} texels: the device takes at most {} a side", desc.name, Size(desc.extent),
                    limits.maxSideTexels);
    RequireFits(desc, desc.extent.Texels() * BytesPerTexel(desc.format), limits);

    vk::ImageCreateInfo info;
    info.imageType = vk::ImageType::e2D;
    info.format = VulkanFormat(desc.format);
    info.extent = vk::Extent3D(width, height, 1);
    info.mipLevels = info.arrayLayers = 1;
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
            desc.name, Size(desc.extent), FormatName(desc.format), MiB(needs.size), MiB(i.device->memoryBytes),
            error.what());
    }
    i.ownImage.bindMemory(*i.memory, 0);

    vk::ImageViewCreateInfo viewInfo;
    viewInfo.image = i.image;
    viewInfo.viewType = vk::ImageViewType::e2D;
    viewInfo.format = info.format;
    const auto aspect =
        desc.format == Format::Depth32F ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
    viewInfo.subresourceRange = vk::ImageSubresourceRange(aspect, 0, 1, 0, 1);
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
