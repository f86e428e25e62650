#include "runtime/transfer.h"

#include <algorithm>
#include <cstring>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint64_t kStagingBytes = 64 << 20;

struct StagingBuffer : Buffer {
    StagingBuffer(Device& device, uint64_t bytes)
        : Buffer(device.impl(), bytes, vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst,
                 vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent,
                 "boxcar staging") {}
};

void SubmitAndLetTheHostRead(CommandList& commands) {
    const vk::MemoryBarrier2 toHost(vk::PipelineStageFlagBits2::eTransfer, vk::AccessFlagBits2::eTransferWrite,
                                    vk::PipelineStageFlagBits2::eHost, vk::AccessFlagBits2::eHostRead);
    commands.impl().own.pipelineBarrier2(vk::DependencyInfo({}, toHost));
    commands.SubmitAndWait();
}

// Calls copy(staging, offset of the part in the bytes, its bytes) for each part.
template <typename Copy>
void ForEachPart(Device& device, uint64_t bytes, Copy copy) {
    const uint64_t partBytes = std::min(bytes, kStagingBytes);
    const StagingBuffer staging(device, partBytes);
    for (uint64_t at = 0; at < bytes; at += partBytes)
        copy(staging, at, std::min(partBytes, bytes - at));
}

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
    const StagingBuffer staging(device, slicesPerBand * rowsPerBand * rowBytes);
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
                    SubmitAndLetTheHostRead(commands);
                    std::memcpy(texels.data() + at, staging.Mapped(), bytes);
                });
}

void WriteBytes(Device& device, const StorageBuffer& buffer, std::span<const std::byte> bytes) {
    BOXCAR_ASSERT(bytes.size() == buffer.Bytes());
    ForEachPart(device, bytes.size(), [&](const Buffer& staging, uint64_t at, uint64_t partBytes) {
        std::memcpy(staging.Mapped(), bytes.data() + at, partBytes);
        CommandList commands(device);
        commands.impl().Barrier(buffer, BufferUse::TransferTarget);
        commands.impl().own.copyBuffer(staging.Handle(), buffer.Handle(), vk::BufferCopy(0, at, partBytes));
        commands.SubmitAndWait();
    });
}

void ReadBytes(Device& device, const StorageBuffer& buffer, std::span<std::byte> bytes) {
    BOXCAR_ASSERT(bytes.size() == buffer.Bytes());
    ForEachPart(device, bytes.size(), [&](const Buffer& staging, uint64_t at, uint64_t partBytes) {
        CommandList commands(device);
        commands.impl().Barrier(buffer, BufferUse::TransferSource);
        commands.impl().own.copyBuffer(buffer.Handle(), staging.Handle(), vk::BufferCopy(at, 0, partBytes));
        SubmitAndLetTheHostRead(commands);
        std::memcpy(bytes.data() + at, staging.Mapped(), partBytes);
    });
}

}  // namespace boxcar
