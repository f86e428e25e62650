// A 2D image on the device, a cube map, or a volume.
#pragma once

#include <memory>
#include <string>

#include "runtime/device.h"
#include "runtime/format.h"

namespace boxcar {

struct ImageDesc {
    Extent2D extent;
    Format format = Format::RGBA32F;
    std::string name;          // for debuggers and messages
    uint32_t layers = 1;       // 6: a cube map, faces +x -x +y -y +z -z; its sides are equal
    uint32_t levels = 1;       // mip levels, each half as large as the one before (rounded down, at least 1)
    uint32_t depthTexels = 0;  // above 0: a volume of as many slices, a Texture3D; it has one layer and one level

    bool IsVolume() const { return depthTexels > 0; }
    uint64_t Texels() const { return extent.Texels() * (IsVolume() ? depthTexels : 1); }  // of level 0 of a layer
};

// Levels down to 1 x 1.
uint32_t MipLevels(Extent2D extent);

Extent2D LevelExtent(Extent2D extent, uint32_t level);

// What an image is used for next. A CommandList puts in the barrier that the change needs.
enum class ImageUse { ShaderRead, StorageReadWrite, ColorTarget, DepthTarget, TransferSource, TransferTarget };

// An engine's image, as it stands when it is wrapped. The engine keeps it alive and finds it, after what was
// recorded, in the use that the last command left it in: CommandList::Use puts it where the engine wants it.
struct WrappedImage {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkPipelineStageFlags2 lastStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkAccessFlags2 lastAccess = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
};

// Can be sampled, rendered to and copied from and to as far as the device can do so with its format; one with layers
// or levels can only be sampled and copied to, part by part (CommandList::Copy), and so can a volume. Move-only.
// Remembers its last use in the order of recording: record command lists in the order in which they are submitted.
class Image {
public:
    // Throws Error: a side is 0 or over the device's limit; the memory is more than the device gives to one image, or
    // than it has left; layers or levels that such an image cannot have. The message names the size that was asked
    // for and the limit.
    Image(Device& device, const ImageDesc& desc);

    Image(Device& device, const ImageDesc& desc, const WrappedImage& wrapped);

    ~Image();
    Image(Image&&) noexcept;
    Image& operator=(Image&&) noexcept;

    const ImageDesc& Desc() const;
    Extent2D Extent() const { return Desc().extent; }

    VkImage Handle() const;
    VkImageView View() const;

    struct Impl;
    Impl& impl() const { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace boxcar
