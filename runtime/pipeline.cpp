#include "runtime/pipeline.h"

#include <algorithm>
#include <array>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint32_t kMaxConstantsBytes = 128;  // what every Vulkan device has

vk::DescriptorType DescriptorType(ResourceKind kind, std::string_view shader, std::string_view resource) {
    switch (kind) {
        case ResourceKind::Texture: return vk::DescriptorType::eSampledImage;
        case ResourceKind::Sampler: return vk::DescriptorType::eSampler;
        case ResourceKind::StorageImage: return vk::DescriptorType::eStorageImage;
        default: break;
    }
    throw Error(
        "shader {}: '{}' is neither a texture, a sampler nor a writable texture; put constants into a "
        "BOXCAR_CONSTANTS block",
        shader, resource);
}

struct Stage {
    const EmbeddedShader& shader;
    ShaderLayout layout;
    vk::ShaderStageFlagBits bit;
};

// Collects what both stages use into pipeline.bindings and one list of Vulkan bindings a set.
class SetBuilder {
public:
    explicit SetBuilder(Pipeline::Impl& pipeline) : m_pipeline(pipeline) {}

    void Add(const Stage& stage, const LayoutResource& resource) {
        const auto type = DescriptorType(resource.kind, stage.shader.name, resource.name);
        if (m_sets.size() <= resource.set) m_sets.resize(resource.set + 1);
        auto& set = m_sets[resource.set];
        const auto known = std::ranges::find(set, resource.binding, &vk::DescriptorSetLayoutBinding::binding);
        if (known != set.end()) {
            known->stageFlags |= stage.bit;
            return;
        }
        vk::DescriptorSetLayoutBinding binding(resource.binding, type, 1, stage.bit);
        if (resource.kind == ResourceKind::Sampler) {
            const vk::raii::Sampler* sampler = m_pipeline.device->FindSampler(resource.name);
            if (!sampler)
                throw Error(
                    "shader {}: sampler '{}' is none of {{nearest|linear|anisotropic}}{{Border|Clamp|Repeat|Mirror}}",
                    stage.shader.name, resource.name);
            binding.pImmutableSamplers = &static_cast<const vk::Sampler&>(**sampler);
            binding.descriptorCount = 1;
        } else {
            m_pipeline.bindings.push_back(
                {resource.name, resource.kind, resource.set, resource.binding, resource.dimension});
        }
        set.push_back(binding);
    }

    void Finish() {
        for (const auto& set : m_sets)
            m_pipeline.setLayouts.emplace_back(m_pipeline.device->device, vk::DescriptorSetLayoutCreateInfo({}, set));
        for (const auto& layout : m_pipeline.setLayouts)
            m_pipeline.device->Name(layout, m_pipeline.name);
    }

private:
    Pipeline::Impl& m_pipeline;
    std::vector<std::vector<vk::DescriptorSetLayoutBinding>> m_sets;
};

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
std::vector<vk::VertexInputAttributeDescription> VertexAttributes(const Stage& vertex) {
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

void CheckLink(const Stage& vertex, const Stage& pixel) {
    for (const LayoutVariable& input : pixel.layout.inputs) {
        const auto output = std::ranges::find(vertex.layout.outputs, input.location, &LayoutVariable::location);
        if (output == vertex.layout.outputs.end() || output->type != input.type ||
            output->locationCount != input.locationCount)
            throw Error("{} does not link to {}: input '{}' ({} at location {}) is not written as such",
                        vertex.shader.name, pixel.shader.name, input.name, input.type, input.location);
    }
}

}  // namespace

Pipeline::Pipeline(Device& device, const PipelineDesc& desc) : m_impl(new Impl) {
    Impl& p = *m_impl;
    p.device = &device.impl();
    p.name = desc.pixel.name;
    p.targets = desc.targets;
    p.testsDepth = desc.testsDepth;
    const vk::raii::Device& vulkan = p.device->device;

    const std::array stages = {
        Stage{desc.vertex, ShaderLayoutFromJson(desc.vertex.layoutJson), vk::ShaderStageFlagBits::eVertex},
        Stage{desc.pixel, ShaderLayoutFromJson(desc.pixel.layoutJson), vk::ShaderStageFlagBits::eFragment}};
    CheckLink(stages[0], stages[1]);

    SetBuilder sets(p);
    for (const Stage& stage : stages) {
        for (const LayoutResource& resource : stage.layout.resources) {
            if (resource.kind != ResourceKind::PushConstants) {
                sets.Add(stage, resource);
                continue;
            }
            p.constantsBytes = std::max(p.constantsBytes, resource.sizeBytes);
            p.constantsStages |= stage.bit;
        }
    }
    sets.Finish();
    if (p.constantsBytes > kMaxConstantsBytes)
        throw Error("shader {}: {} bytes of constants, at most {} fit", p.name, p.constantsBytes, kMaxConstantsBytes);

    std::vector<vk::DescriptorSetLayout> setLayouts;
    for (const auto& set : p.setLayouts)
        setLayouts.push_back(*set);
    const vk::PushConstantRange range(p.constantsStages, 0, p.constantsBytes);
    vk::PipelineLayoutCreateInfo layoutInfo({}, setLayouts);
    if (p.constantsBytes > 0) layoutInfo.setPushConstantRanges(range);
    p.layout = vk::raii::PipelineLayout(vulkan, layoutInfo);

    std::vector<vk::raii::ShaderModule> modules;
    std::vector<vk::PipelineShaderStageCreateInfo> stageInfos;
    for (const Stage& stage : stages) {
        vk::ShaderModuleCreateInfo moduleInfo;
        moduleInfo.codeSize = stage.shader.spirv.size_bytes();
        moduleInfo.pCode = stage.shader.spirv.data();
        modules.emplace_back(vulkan, moduleInfo);
        p.device->Name(modules.back(), std::string(stage.shader.name));
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
                                        &oneSample, &depth, &blend, &dynamic, *p.layout);
    info.pNext = &rendering;
    p.pipeline = vk::raii::Pipeline(vulkan, nullptr, info);
    p.device->Name(p.pipeline, p.name);
    p.device->Name(p.layout, p.name);
}

Pipeline::~Pipeline() = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;

}  // namespace boxcar
