#include "runtime/command_list.h"

#include <algorithm>
#include <glm/ext/vector_uint4.hpp>
#include <limits>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint32_t kSetsPerPool = 64;

ImageState StateFor(ImageUse use) {
    using Layout = vk::ImageLayout;
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const auto shaders = Stage::eFragmentShader | Stage::eComputeShader;
    switch (use) {
        case ImageUse::ShaderRead: return {Layout::eShaderReadOnlyOptimal, shaders, Access::eShaderSampledRead};
        case ImageUse::StorageReadWrite:
            return {Layout::eGeneral, shaders, Access::eShaderStorageRead | Access::eShaderStorageWrite};
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

bool Writes(vk::AccessFlags2 access) {
    using Access = vk::AccessFlagBits2;
    return static_cast<bool>(access &
                             (Access::eShaderStorageWrite | Access::eColorAttachmentWrite |
                              Access::eDepthStencilAttachmentWrite | Access::eTransferWrite | Access::eMemoryWrite));
}

void CheckTarget(const Pass& pass, const Image& image, Format format) {
    const ImageDesc& target = image.Desc();
    if (target.format != format)
        throw Error("pass '{}' writes '{}', which is {}: its pipeline writes {}", pass.name, target.name,
                    FormatName(target.format), FormatName(format));
    if (target.extent != pass.writes[0]->Extent())
        throw Error("pass '{}' writes '{}' and '{}', which differ in extent", pass.name, pass.writes[0]->Desc().name,
                    target.name);
    if (target.IsVolume())
        throw Error("pass '{}' writes '{}', which is a volume: draw into an image and read that", pass.name,
                    target.name);
    if (target.layers != 1 || target.levels != 1)
        throw Error("pass '{}' writes '{}', which has {} layers and {} levels: draw an image of one and copy it",
                    pass.name, target.name, target.layers, target.levels);
    for (const Read& read : pass.reads)
        if (read.image == &image)
            throw Error("pass '{}' reads and writes '{}' at once: what it would read is undefined", pass.name,
                        target.name);
}

vk::ClearColorValue ClearValue(const glm::vec4& rgba, Format format) {
    if (format == Format::RGBA32UI) {
        const glm::uvec4 words(rgba);
        return std::array{words.x, words.y, words.z, words.w};
    }
    return std::array{rgba.x, rgba.y, rgba.z, rgba.w};
}

void Check(const Pass& pass, const Pipeline::Impl& pipeline) {
    if (pass.writes.size() != pipeline.targets.size())
        throw Error("pass '{}' writes {} images, its pipeline {}", pass.name, pass.writes.size(),
                    pipeline.targets.size());
    if (pipeline.drawsMesh != (pass.mesh != nullptr))
        throw Error("pass '{}' gives {} mesh: {} draws {}", pass.name, pass.mesh ? "a" : "no", pipeline.name,
                    pipeline.drawsMesh ? "one" : "a quad");
    if (pipeline.testsDepth != (pass.depth != nullptr))
        throw Error("pass '{}' gives {} depth image: its pipeline tests {}", pass.name, pass.depth ? "a" : "no",
                    pipeline.testsDepth ? "depth" : "none");
    for (size_t i = 0; i < pass.writes.size(); i++)
        CheckTarget(pass, *pass.writes[i], pipeline.targets[i]);
    if (pass.depth) CheckTarget(pass, *pass.depth, Format::Depth32F);
    if (pass.constants.size() != pipeline.constantsBytes)
        throw Error("pass '{}' has {} bytes of constants, {} takes {}", pass.name, pass.constants.size(),
                    pipeline.name, pipeline.constantsBytes);
}

TextureDimension DimensionOf(const ImageDesc& image) {
    return image.IsVolume()    ? TextureDimension::Volume
           : image.layers == 6 ? TextureDimension::Cube
                               : TextureDimension::Flat;
}

const char* NameOf(TextureDimension dimension) {
    switch (dimension) {
        case TextureDimension::Flat: return "a 2D image";
        case TextureDimension::Volume: return "a volume";
        case TextureDimension::Cube: return "a cube map";
        default: return "no kind of image that there is";
    }
}

const Image& FindRead(const Pass& pass, const Binding& binding, const Pipeline::Impl& pipeline) {
    const auto read = std::ranges::find(pass.reads, binding.name, &Read::name);
    if (read == pass.reads.end())
        throw Error("pass '{}' gives nothing to read as '{}' of {}", pass.name, binding.name, pipeline.name);
    const ImageDesc& image = read->image->Desc();
    if (DimensionOf(image) != binding.dimension)
        throw Error("pass '{}' gives '{}', {}, to read as '{}' of {}, which is {}", pass.name, image.name,
                    NameOf(DimensionOf(image)), binding.name, pipeline.name, NameOf(binding.dimension));
    return *read->image;
}

// Command buffers are kept and recorded anew: freed ones are a race in the validation layer (1.3.239), whose own
// thread forgets the labels of the old buffer while the next one, often of the same address, is being labeled.
vk::raii::CommandBuffer TakeCommands(Device::Impl& device) {
    if (device.idleCommands.empty()) {
        auto commands = std::move(
            device.device.allocateCommandBuffers({**device.commandPool, vk::CommandBufferLevel::ePrimary, 1})[0]);
        device.Name(commands, "boxcar commands");
        return commands;
    }
    auto commands = std::move(device.idleCommands.back());
    device.idleCommands.pop_back();
    commands.reset();
    return commands;
}

}  // namespace

CommandList::CommandList(Device& device, Timing timing) : m_impl(new Impl) {
    Impl& c = *m_impl;
    c.device = &device.impl();
    c.own = TakeCommands(*c.device);
    c.commands = *c.own;
    c.own.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    if (timing == Timing::On && c.device->nanosecondsPerTick > 0) c.timer.emplace(*c.device);
}

CommandList::CommandList(Device& device, VkCommandBuffer wrapped) : m_impl(new Impl) {
    m_impl->device = &device.impl();
    m_impl->commands = wrapped;
}

CommandList::Impl::~Impl() {
    if (*own && !isPending) device->idleCommands.push_back(std::move(own));
}

CommandList::~CommandList() = default;
CommandList::CommandList(CommandList&&) noexcept = default;
CommandList& CommandList::operator=(CommandList&&) noexcept = default;

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

std::vector<vk::DescriptorSet> CommandList::Impl::AllocateSets(const Pipeline::Impl& pipeline) {
    std::vector<vk::DescriptorSetLayout> layouts;
    for (const auto& layout : pipeline.setLayouts)
        layouts.push_back(*layout);
    if (layouts.empty()) return {};
    const auto& dispatch = *device->device.getDispatcher();
    for (const bool fresh : {false, true}) {
        if (fresh || descriptorPools.empty()) {
            const std::array sizes = {vk::DescriptorPoolSize(vk::DescriptorType::eSampledImage, 4 * kSetsPerPool),
                                      vk::DescriptorPoolSize(vk::DescriptorType::eStorageImage, 4 * kSetsPerPool),
                                      vk::DescriptorPoolSize(vk::DescriptorType::eSampler, 4 * kSetsPerPool)};
            descriptorPools.emplace_back(device->device, vk::DescriptorPoolCreateInfo({}, kSetsPerPool, sizes));
            device->Name(descriptorPools.back(), "boxcar descriptors");
        }
        std::vector<vk::DescriptorSet> sets(layouts.size());
        const vk::DescriptorSetAllocateInfo info(*descriptorPools.back(), layouts);
        const vk::Result result = (*device->device).allocateDescriptorSets(&info, sets.data(), dispatch);
        if (result != vk::Result::eSuccess) continue;
        for (const vk::DescriptorSet set : sets)
            device->Name(set, pipeline.name);
        return sets;
    }
    throw Error("the device has no memory left for descriptors");
}

void CommandList::Impl::BeginPass(std::string_view name) {
    const std::string label(name);
    if (device->hasDebugUtils)
        commands.beginDebugUtilsLabelEXT(vk::DebugUtilsLabelEXT(label.c_str()), *device->device.getDispatcher());
    if (timer) timer->Begin(commands, label);
}

void CommandList::Impl::EndPass() {
    if (timer) timer->End(commands);
    if (device->hasDebugUtils) commands.endDebugUtilsLabelEXT(*device->device.getDispatcher());
}

void CommandList::Draw(const Pass& pass) {
    Impl& c = *m_impl;
    const Pipeline::Impl& p = pass.pipeline.impl();
    const auto& dispatch = *c.device->device.getDispatcher();
    Check(pass, p);

    const std::vector<vk::DescriptorSet> sets = c.AllocateSets(p);
    for (const Binding& binding : p.bindings) {
        const Image& image = FindRead(pass, binding, p);
        const bool storage = binding.kind == ResourceKind::StorageImage;
        c.Barrier(image, storage ? ImageUse::StorageReadWrite : ImageUse::ShaderRead);
        const vk::DescriptorImageInfo info({}, image.View(), image.impl().state.layout);
        const auto type = storage ? vk::DescriptorType::eStorageImage : vk::DescriptorType::eSampledImage;
        const vk::WriteDescriptorSet write(sets[binding.set], binding.binding, 0, type, info);
        (*c.device->device).updateDescriptorSets(write, {}, dispatch);
    }
    std::vector<vk::RenderingAttachmentInfo> attachments;
    for (const Image* target : pass.writes) {
        c.Barrier(*target, ImageUse::ColorTarget);
        vk::RenderingAttachmentInfo attachment(target->View(), target->impl().state.layout);
        const bool keeps = pass.area || pass.mesh || pass.depth;
        attachment.loadOp = keeps ? vk::AttachmentLoadOp::eLoad : vk::AttachmentLoadOp::eDontCare;
        attachment.storeOp = vk::AttachmentStoreOp::eStore;
        if (pass.clearColor) {
            attachment.loadOp = vk::AttachmentLoadOp::eClear;
            attachment.clearValue.color = ClearValue(*pass.clearColor, target->Desc().format);
        }
        attachments.push_back(attachment);
    }
    vk::RenderingAttachmentInfo depth;
    if (pass.depth) {
        c.Barrier(*pass.depth, ImageUse::DepthTarget);
        depth = vk::RenderingAttachmentInfo(pass.depth->View(), pass.depth->impl().state.layout);
        depth.loadOp = pass.clearsDepth ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad;
        depth.storeOp = vk::AttachmentStoreOp::eStore;
        depth.clearValue.depthStencil = vk::ClearDepthStencilValue(1);
    }

    const auto [width, height] = pass.writes[0]->Extent();
    const Rect area = pass.area.value_or(Rect{0, 0, width, height});
    const vk::Rect2D rect({static_cast<int32_t>(area.xTexels), static_cast<int32_t>(area.yTexels)},
                          {area.widthTexels, area.heightTexels});
    // Direct3D's clip space has y up: a negative height turns the viewport over.
    const vk::Viewport viewport(0, static_cast<float>(height), static_cast<float>(width), -static_cast<float>(height),
                                0, 1);

    c.BeginPass(pass.name);
    c.commands.beginRendering(vk::RenderingInfo({}, rect, 1, 0, attachments, pass.depth ? &depth : nullptr),
                              dispatch);
    c.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *p.pipeline, dispatch);
    c.commands.setViewport(0, viewport, dispatch);
    c.commands.setScissor(0, rect, dispatch);
    if (!sets.empty())
        c.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *p.layout, 0, sets, {}, dispatch);
    if (p.constantsBytes > 0)
        c.commands.pushConstants(*p.layout, p.constantsStages, 0, p.constantsBytes, pass.constants.data(), dispatch);
    if (pass.mesh) {
        const Mesh::Impl& mesh = pass.mesh->impl();
        c.commands.bindVertexBuffers(0, mesh.buffer.Handle(), vk::DeviceSize{0}, dispatch);
        c.commands.bindIndexBuffer(mesh.buffer.Handle(), mesh.indicesOffsetBytes, vk::IndexType::eUint32, dispatch);
        c.commands.drawIndexed(mesh.indexCount, 1, 0, 0, 0, dispatch);
    } else {
        c.commands.draw(4, 1, 0, 0, dispatch);
    }
    c.commands.endRendering(dispatch);
    c.EndPass();
}

void CommandList::Use(const Image& image, ImageUse use) {
    m_impl->Barrier(image, use);
}

void CommandList::Copy(const Image& source, const Image& target, uint32_t layer, uint32_t level) {
    Impl& c = *m_impl;
    const ImageDesc &from = source.Desc(), &to = target.Desc();
    BOXCAR_ASSERT(!from.IsVolume() && !to.IsVolume());
    BOXCAR_ASSERT(from.layers == 1 && from.levels == 1 && from.format == to.format && layer < to.layers &&
                  level < to.levels && from.extent == LevelExtent(to.extent, level) && &source != &target);
    c.Barrier(source, ImageUse::TransferSource);
    c.Barrier(target, ImageUse::TransferTarget);
    const auto aspect = AspectOf(from.format);
    const vk::ImageCopy region({aspect, 0, 0, 1}, {}, {aspect, level, layer, 1}, {},
                               {from.extent.widthTexels, from.extent.heightTexels, 1});
    c.commands.copyImage(source.Handle(), source.impl().state.layout, target.Handle(), target.impl().state.layout,
                         region, *c.device->device.getDispatcher());
}

void CommandList::Clear(const Image& image, const float (&rgba)[4]) {
    Impl& c = *m_impl;
    BOXCAR_ASSERT(image.Desc().format != Format::Depth32F);
    c.Barrier(image, ImageUse::TransferTarget);
    const vk::ClearColorValue value = ClearValue({rgba[0], rgba[1], rgba[2], rgba[3]}, image.Desc().format);
    c.commands.clearColorImage(
        image.Handle(), image.impl().state.layout, value,
        vk::ImageSubresourceRange(vk::ImageAspectFlagBits::eColor, 0, image.Desc().levels, 0, image.Desc().layers),
        *c.device->device.getDispatcher());
}

void CommandList::SubmitAndWait() {
    Impl& c = *m_impl;
    BOXCAR_ASSERT(*c.own);
    c.own.end();
    const vk::raii::Fence fence(c.device->device, vk::FenceCreateInfo());
    c.device->Name(fence, "boxcar submit");
    const vk::CommandBuffer commands = *c.own;
    c.isPending = true;
    c.device->queue.submit(vk::SubmitInfo({}, {}, commands), *fence);
    if (c.device->device.waitForFences(*fence, true, std::numeric_limits<uint64_t>::max()) != vk::Result::eSuccess)
        throw Error("the device '{}' did not finish", c.device->info.name);
    c.isPending = false;
    if (c.timer) c.times = c.timer->Times();
}

std::vector<PassTime> CommandList::PassTimes() const {
    return m_impl->times;
}
VkCommandBuffer CommandList::Handle() const {
    return m_impl->commands;
}

}  // namespace boxcar
