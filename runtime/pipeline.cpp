#include "runtime/pipeline.h"

#include <algorithm>
#include <array>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

struct VertexMember {
    std::string_view semantic;
    uint32_t offsetBytes;
    vk::Format format;
};

constexpr VertexMember kVertexMembers[] = {
    {"POSITION0", offsetof(Vertex, position), vk::Format::eR32G32B32Sfloat},
    {"SV_POSITION0", offsetof(Vertex, position), vk::Format::eR32G32B32Sfloat},  // of an inout parameter
    {"NORMAL0", offsetof(Vertex, normal), vk::Format::eR32G32B32Sfloat},
    {"TEXCOORD0", offsetof(Vertex, uv), vk::Format::eR32G32Sfloat},
};

// A shader may take fewer components than there are, or more: those are 0, 0 and 1, as in Direct3D.
std::vector<vk::VertexInputAttributeDescription> VertexAttributes(const StageShader& vertex) {
    std::vector<vk::VertexInputAttributeDescription> attributes;
    for (const LayoutVariable& input : vertex.layout.inputs) {
        const auto member = std::ranges::find(kVertexMembers, input.semantic, &VertexMember::semantic);
        if (member == std::end(kVertexMembers) || !input.type.starts_with("float") || input.locationCount != 1)
            throw Error(
                "shader {}: vertex input '{}' ({} {}) is not in a mesh, which has float3 POSITION, float3 "
                "NORMAL and float2 TEXCOORD0",
                vertex.shader.name, input.name, input.type, input.semantic);
        attributes.push_back({input.location, 0, member->format, member->offsetBytes});
    }
    return attributes;
}

vk::CullModeFlags CullMode(Cull cull) {
    switch (cull) {
        case Cull::Back: return vk::CullModeFlagBits::eBack;
        case Cull::Front: return vk::CullModeFlagBits::eFront;
        case Cull::None: break;
    }
    return vk::CullModeFlagBits::eNone;
}

void CheckLink(const StageShader& vertex, const StageShader& pixel) {
    for (const LayoutVariable& input : pixel.layout.inputs) {
        const auto output = std::ranges::find(vertex.layout.outputs, input.location, &LayoutVariable::location);
        if (output == vertex.layout.outputs.end() || output->type != input.type ||
            output->locationCount != input.locationCount)
            throw Error("{} does not link to {}: input '{}' ({} at location {}) is not written as such",
                        vertex.shader.name, pixel.shader.name, input.name, input.type, input.location);
    }
}

}  // namespace

Pipeline::Pipeline(Device& device, const PipelineDesc& desc) {
    Device::Impl& d = device.impl();
    const std::array stages = {
        StageShader{desc.vertex, ShaderLayoutFromJson(desc.vertex.layoutJson), vk::ShaderStageFlagBits::eVertex},
        StageShader{desc.pixel, ShaderLayoutFromJson(desc.pixel.layoutJson), vk::ShaderStageFlagBits::eFragment}};
    CheckLink(stages[0], stages[1]);
    m_impl.reset(new Impl{{d, std::string(desc.pixel.name), stages}, desc.targets, false, desc.testsDepth, nullptr});
    Impl& p = *m_impl;

    std::vector<vk::raii::ShaderModule> modules;
    std::vector<vk::PipelineShaderStageCreateInfo> stageInfos;
    for (const StageShader& stage : stages) {
        modules.push_back(MakeModule(d, stage));
        stageInfos.push_back({{}, stage.bit, *modules.back(), stage.layout.entry.c_str()});
    }

    const auto attributes = VertexAttributes(stages[0]);
    p.drawsMesh = !attributes.empty();
    const vk::VertexInputBindingDescription vertexBuffer(0, sizeof(Vertex));
    vk::PipelineVertexInputStateCreateInfo vertexInput({}, {}, attributes);
    if (p.drawsMesh) vertexInput.setVertexBindingDescriptions(vertexBuffer);
    const vk::PipelineInputAssemblyStateCreateInfo assembly(
        {}, p.drawsMesh ? vk::PrimitiveTopology::eTriangleList : vk::PrimitiveTopology::eTriangleStrip);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo rasterization;
    rasterization.lineWidth = 1;
    rasterization.cullMode = CullMode(desc.cull);
    // Vulkan measures the turn where Direct3D does, on the screen, after the viewport is turned over.
    rasterization.frontFace = vk::FrontFace::eCounterClockwise;
    vk::PipelineDepthStencilStateCreateInfo depth;
    depth.depthTestEnable = depth.depthWriteEnable = desc.testsDepth;
    depth.depthCompareOp = vk::CompareOp::eLess;
    const vk::PipelineMultisampleStateCreateInfo oneSample;
    vk::PipelineColorBlendAttachmentState overwrite;
    overwrite.colorWriteMask = vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags;
    const std::vector blends(desc.targets.size(), overwrite);
    const vk::PipelineColorBlendStateCreateInfo blend({}, false, {}, blends);
    const std::array dynamicStates = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamicStates);
    std::vector<vk::Format> formats;
    for (const Format format : desc.targets)
        formats.push_back(VulkanFormat(format));
    const vk::PipelineRenderingCreateInfo rendering(
        0, formats, desc.testsDepth ? VulkanFormat(Format::Depth32F) : vk::Format::eUndefined);

    vk::GraphicsPipelineCreateInfo info({}, stageInfos, &vertexInput, &assembly, {}, &viewport, &rasterization,
                                        &oneSample, &depth, &blend, &dynamic, *p.shaders.layout);
    info.pNext = &rendering;
    p.pipeline = vk::raii::Pipeline(d.device, nullptr, info);
    d.Name(p.pipeline, p.shaders.name);
}

Pipeline::~Pipeline() = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;

}  // namespace boxcar
