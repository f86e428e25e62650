#include "runtime/transfer.h"

#include <algorithm>
#include <cstring>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint64_t kStagingBytes = 64 << 20;

// Calls copy(staging, region, offset of the band in the texels, its bytes) for each band of rows of each slice.
template <typename Copy>
void ForEachBand(Device& device, const Image& image, uint64_t texelBytes, Copy copy) {
    const auto [width, height] = image.Extent();
    const uint32_t depth = std::max(image.Desc().depthTexels, 1u);
    BOXCAR_ASSERT(image.Desc().layers == 1 && image.Desc().levels == 1);
    const uint64_t rowBytes = uint64_t{width} * BytesPerTexel(image.Desc().format);
    const uint64_t sliceBytes = rowBytes * height;
    BOXCAR_ASSERT(texelBytes == sliceBytes * depth);
    const auto rowsPerBand = static_cast<uint32_t>(std::clamp<uint64_t>(kStagingBytes / rowBytes, 1, height));
    const auto slicesPerBand = static_cast<uint32_t>(std::clamp<uint64_t>(kStagingBytes / sliceBytes, 1, depth));
    using Usage = vk::BufferUsageFlagBits;
    using Property = vk::MemoryPropertyFlagBits;
    const Buffer staging(device.impl(), slicesPerBand * rowsPerBand * rowBytes,
                         Usage::eTransferSrc | Usage::eTransferDst, Property::eHostVisible | Property::eHostCoherent,
                         "boxcar staging");
    for (uint32_t slice = 0; slice < depth; slice += slicesPerBand)
        for (uint32_t row = 0; row < height; row += rowsPerBand) {
            const uint32_t slices = std::min(slicesPerBand, depth - slice);
            const uint32_t rows = std::min(rowsPerBand, height - row);
            const vk::BufferImageCopy region(0, 0, 0, {AspectOf(image.Desc().format), 0, 0, 1},
                                             {0, static_cast<int32_t>(row), static_cast<int32_t>(slice)},
                                             {width, rows, slices});
            copy(staging, region, slice * sliceBytes + row * rowBytes, slices * rows * rowBytes);
        }
}

}  // namespace

void WriteTexels(Device& device, const Image& image, std::span<const std::byte> texels) {
    ForEachBand(device, image, texels.size(),
                [&](const Buffer& staging, const vk::BufferImageCopy& region, uint64_t at, uint64_t bytes) {
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
                [&](const Buffer& staging, const vk::BufferImageCopy& region, uint64_t at, uint64_t bytes) {
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
