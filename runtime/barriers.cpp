#include "runtime/vulkan.h"

namespace boxcar {
namespace {

constexpr auto kShaders = vk::PipelineStageFlagBits2::eVertexShader | vk::PipelineStageFlagBits2::eFragmentShader |
                          vk::PipelineStageFlagBits2::eComputeShader;
constexpr auto kStorageAccess = vk::AccessFlagBits2::eShaderStorageRead | vk::AccessFlagBits2::eShaderStorageWrite;

ImageState StateFor(ImageUse use) {
    using Layout = vk::ImageLayout;
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    switch (use) {
        case ImageUse::ShaderRead: return {Layout::eShaderReadOnlyOptimal, kShaders, Access::eShaderSampledRead};
        case ImageUse::StorageReadWrite: return {Layout::eGeneral, kShaders, kStorageAccess};
        case ImageUse::ColorTarget:
            return {Layout::eColorAttachmentOptimal, Stage::eColorAttachmentOutput,
                    Access::eColorAttachmentRead | Access::eColorAttachmentWrite};
        case ImageUse::DepthTarget:
            return {Layout::eDepthAttachmentOptimal, Stage::eEarlyFragmentTests | Stage::eLateFragmentTests,
                    Access::eDepthStencilAttachmentRead | Access::eDepthStencilAttachmentWrite};
        case ImageUse::TransferSource: return {Layout::eTransferSrcOptimal, Stage::eTransfer, Access::eTransferRead};
        case ImageUse::TransferTarget: break;
    }
    return {Layout::eTransferDstOptimal, Stage::eTransfer, Access::eTransferWrite};
}

BufferState StateFor(BufferUse use) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    switch (use) {
        case BufferUse::Storage: return {kShaders, kStorageAccess};
        case BufferUse::TransferSource: return {Stage::eTransfer, Access::eTransferRead};
        case BufferUse::TransferTarget: break;
    }
    return {Stage::eTransfer, Access::eTransferWrite};
}

bool Writes(vk::AccessFlags2 access) {
    using Access = vk::AccessFlagBits2;
    return static_cast<bool>(access &
                             (Access::eShaderStorageWrite | Access::eColorAttachmentWrite |
                              Access::eDepthStencilAttachmentWrite | Access::eTransferWrite | Access::eMemoryWrite));
}

}  // namespace

void CommandList::Impl::Barrier(const Image& image, ImageUse use) {
    ImageState& now = image.impl().state;
    const ImageState next = StateFor(use);
    const bool readAfterRead = now.layout == next.layout && !Writes(now.access) && !Writes(next.access);
    if (readAfterRead) return;  // the barrier into this state covers every read in it
    const auto aspect = AspectOf(image.Desc().format);
    const vk::ImageMemoryBarrier2 barrier(now.stages, now.access, next.stages, next.access, now.layout, next.layout,
                                          VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, image.Handle(),
                                          {aspect, 0, image.Desc().levels, 0, image.Desc().layers});
    commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier), *device->device.getDispatcher());
    now = next;
}

void CommandList::Impl::Barrier(const StorageBuffer& buffer, BufferUse use) {
    BufferState& now = buffer.impl().state;
    const BufferState next = StateFor(use);
    if (!Writes(now.access) && !Writes(next.access) && now.stages == next.stages) return;
    const vk::BufferMemoryBarrier2 barrier(now.stages, now.access, next.stages, next.access, VK_QUEUE_FAMILY_IGNORED,
                                           VK_QUEUE_FAMILY_IGNORED, buffer.Handle(), 0, VK_WHOLE_SIZE);
    commands.pipelineBarrier2(vk::DependencyInfo({}, {}, barrier), *device->device.getDispatcher());
    now = next;
}

}  // namespace boxcar
