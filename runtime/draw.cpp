// A pass that draws: its targets are checked and attached, then a quad or a mesh is drawn into them.
#include <algorithm>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

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
    const bool isRead = std::ranges::count(pass.reads, &image, &Read::image) > 0;
    if (isRead || std::ranges::count(pass.storage, &image, &Storage::image) > 0)
        throw Error("pass '{}' {} '{}' at once: what it would read is undefined", pass.name,
                    isRead ? "reads and writes" : "stores to and draws", target.name);
}

void CheckTargets(const Pass& pass, const Pipeline::Impl& pipeline) {
    if (pass.writes.size() != pipeline.targets.size())
        throw Error("pass '{}' writes {} images, its pipeline {}", pass.name, pass.writes.size(),
                    pipeline.targets.size());
    if (pipeline.drawsMesh != (pass.mesh != nullptr))
        throw Error("pass '{}' gives {} mesh: {} draws {}", pass.name, pass.mesh ? "a" : "no", pipeline.shaders.name,
                    pipeline.drawsMesh ? "one" : "a quad");
    if (pipeline.testsDepth != (pass.depth != nullptr))
        throw Error("pass '{}' gives {} depth image: its pipeline tests {}", pass.name, pass.depth ? "a" : "no",
                    pipeline.testsDepth ? "depth" : "none");
    for (size_t i = 0; i < pass.writes.size(); i++)
        CheckTarget(pass, *pass.writes[i], pipeline.targets[i]);
    if (pass.depth) CheckTarget(pass, *pass.depth, Format::Depth32F);
}

std::vector<vk::RenderingAttachmentInfo> ColorAttachments(const Pass& pass) {
    std::vector<vk::RenderingAttachmentInfo> attachments;
    const bool keeps = pass.area || pass.mesh || pass.depth;
    for (const Image* target : pass.writes) {
        vk::RenderingAttachmentInfo& attachment =
            attachments.emplace_back(target->View(), target->impl().state.layout);
        attachment.loadOp = keeps ? vk::AttachmentLoadOp::eLoad : vk::AttachmentLoadOp::eDontCare;
        attachment.storeOp = vk::AttachmentStoreOp::eStore;
        if (!pass.clearColor) continue;
        attachment.loadOp = vk::AttachmentLoadOp::eClear;
        attachment.clearValue.color = ClearValue(*pass.clearColor, target->Desc().format);
    }
    return attachments;
}

std::optional<vk::RenderingAttachmentInfo> DepthAttachment(const Pass& pass) {
    if (!pass.depth) return {};
    vk::RenderingAttachmentInfo depth(pass.depth->View(), pass.depth->impl().state.layout);
    depth.loadOp = pass.clearsDepth ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad;
    depth.storeOp = vk::AttachmentStoreOp::eStore;
    depth.clearValue.depthStencil = vk::ClearDepthStencilValue(1);
    return depth;
}

vk::Rect2D DrawnRect(const Pass& pass) {
    const auto [width, height] = pass.writes[0]->Extent();
    const Rect area = pass.area.value_or(Rect{0, 0, width, height});
    return {{static_cast<int32_t>(area.xTexels), static_cast<int32_t>(area.yTexels)},
            {area.widthTexels, area.heightTexels}};
}

// Direct3D's clip space has y up: a negative height turns the viewport over.
vk::Viewport ViewportOf(Extent2D extent) {
    const auto width = static_cast<float>(extent.widthTexels), height = static_cast<float>(extent.heightTexels);
    return {0, height, width, -height, 0, 1};
}

}  // namespace

void CommandList::Draw(const Pass& pass) {
    Impl& c = *m_impl;
    const auto& dispatch = *c.device->device.getDispatcher();
    const Pipeline::Impl& pipeline = pass.pipeline.impl();
    CheckTargets(pass, pipeline);
    const PassResources resources{pass.name, pass.reads, pass.storage, pass.constants};
    const std::vector<vk::DescriptorSet> sets = c.Prepare(pipeline.shaders, resources);
    for (const Image* target : pass.writes)
        c.Barrier(*target, ImageUse::ColorTarget);
    if (pass.depth) c.Barrier(*pass.depth, ImageUse::DepthTarget);
    const auto colors = ColorAttachments(pass);
    const auto depth = DepthAttachment(pass);
    const vk::Rect2D rect = DrawnRect(pass);

    c.BeginPass(pass.name);
    c.commands.beginRendering(vk::RenderingInfo({}, rect, 1, 0, colors, depth ? &*depth : nullptr), dispatch);
    c.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.pipeline, dispatch);
    c.Bind(vk::PipelineBindPoint::eGraphics, pipeline.shaders, sets, pass.constants);
    c.commands.setViewport(0, ViewportOf(pass.writes[0]->Extent()), dispatch);
    c.commands.setScissor(0, rect, dispatch);
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

}  // namespace boxcar
