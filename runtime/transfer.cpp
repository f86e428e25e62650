#include "runtime/transfer.h"

#include <algorithm>
#include <cstring>

#include "runtime/vulkan.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

constexpr uint64_t kStagingBytes = 64 << 20;

// Memory that both sides see, mapped for as long as it lives.
class StagingBuffer {
public:
    StagingBuffer(Device::Impl& device, uint64_t bytes) : m_device(device) {
        using Usage = vk::BufferUsageFlagBits;
        using Property = vk::MemoryPropertyFlagBits;
        m_buffer = vk::raii::Buffer(device.device,
                                    vk::BufferCreateInfo({}, bytes, Usage::eTransferSrc | Usage::eTransferDst));
        const vk::MemoryRequirements needs = m_buffer.getMemoryRequirements();
        const auto type =
            device.MemoryType(needs.memoryTypeBits, Property::eHostVisible | Property::eHostCoherent).value();
        m_memory = vk::raii::DeviceMemory(device.device, vk::MemoryAllocateInfo(needs.size, type));
        m_buffer.bindMemory(*m_memory, 0);
        m_mapped = static_cast<std::byte*>(m_memory.mapMemory(0, VK_WHOLE_SIZE));
        device.Name(m_buffer, "boxcar staging");
        device.Name(m_memory, "boxcar staging");
        m_bytes = needs.size;
        device.CountMemory(static_cast<int64_t>(m_bytes));
    }
    ~StagingBuffer() { m_device.CountMemory(-static_cast<int64_t>(m_bytes)); }
    StagingBuffer(StagingBuffer&&) = delete;

    vk::Buffer Handle() const { return *m_buffer; }
    std::byte* Mapped() const { return m_mapped; }

private:
    Device::Impl& m_device;
    vk::raii::Buffer m_buffer = nullptr;
    vk::raii::DeviceMemory m_memory = nullptr;
    std::byte* m_mapped = nullptr;
    uint64_t m_bytes = 0;
};

// Calls copy(staging, region, offset of the band in the texels, its bytes) for each band of rows.
template <typename Copy>
void ForEachBand(Device& device, const Image& image, uint64_t texelBytes, Copy copy) {
    const auto [width, height] = image.Extent();
    const uint64_t rowBytes = uint64_t{width} * BytesPerTexel(image.Desc().format);
    BOXCAR_ASSERT(texelBytes == rowBytes * height);
    const uint32_t rowsPerBand = static_cast<uint32_t>(std::clamp<uint64_t>(kStagingBytes / rowBytes, 1, height));
    const StagingBuffer staging(device.impl(), rowsPerBand * rowBytes);
    for (uint32_t row = 0; row < height; row += rowsPerBand) {
        const uint32_t rows = std::min(rowsPerBand, height - row);
        const auto aspect = image.Desc().format == Format::Depth32F ? vk::ImageAspectFlagBits::eDepth
                                                                    : vk::ImageAspectFlagBits::eColor;
        const vk::BufferImageCopy region(0, 0, 0, {aspect, 0, 0, 1}, {0, static_cast<int32_t>(row), 0},
                                         {width, rows, 1});
        copy(staging, region, row * rowBytes, rows * rowBytes);
    }
}

}  // namespace

void WriteTexels(Device& device, const Image& image, std::span<const std::byte> texels) {
    ForEachBand(device, image, texels.size(),
                [&](const StagingBuffer& staging, const vk::BufferImageCopy& region, uint64_t at, uint64_t bytes) {
                    std::memcpy(staging.Mapped(), texels.data() + at, bytes);
                    CommandList commands(device);
                    commands.Use(image, ImageUse::TransferTarget);
                    commands.impl().own.copyBufferToImage(staging.Handle(), image.Handle(), image.impl().state.layout,
                                                          region);
                    commands.SubmitAndWait();
                });
}

void ReadTexels(Device& device, const Image& image, std::span<std::byte> texels) {
    ForEachBand(device, image, texels.size(),
                [&](const StagingBuffer& staging, const vk::BufferImageCopy& region, uint64_t at, uint64_t bytes) {
                    CommandList commands(device);
                    commands.Use(image, ImageUse::TransferSource);
                    commands.impl().own.copyImageToBuffer(image.Handle(), image.impl().state.layout, staging.Handle(),
                                                          region);
                    const vk::MemoryBarrier2 toHost(
                        vk::PipelineStageFlagBits2::eTransfer, vk::AccessFlagBits2::eTransferWrite,
                        vk::PipelineStageFlagBits2::eHost, vk::AccessFlagBits2::eHostRead);
                    commands.impl().own.pipelineBarrier2(vk::DependencyInfo({}, toHost));
                    commands.SubmitAndWait();
                    std::memcpy(texels.data() + at, staging.Mapped(), bytes);
                });
}

}  // namespace boxcar
