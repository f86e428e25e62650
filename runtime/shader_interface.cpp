// From the reflected layouts of a pipeline's shaders to what Vulkan wants to be told.
#include <algorithm>

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
        case ResourceKind::StorageBuffer: return vk::DescriptorType::eStorageBuffer;
        default: break;
    }
    throw Error(
        "shader {}: '{}' is not a texture, a sampler or a buffer that the runtime can bind; put constants into a "
        "BOXCAR_CONSTANTS block",
        shader, resource);
}

// Collects what all stages use into the bindings of the interface and one list of Vulkan bindings a set.
class SetBuilder {
public:
    SetBuilder(Device::Impl& device, ShaderInterface& shaders) : m_device(device), m_shaders(shaders) {}

    void Add(const StageShader& stage, const LayoutResource& resource) {
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
            const vk::raii::Sampler* sampler = m_device.FindSampler(resource.name);
            if (!sampler)
                throw Error(
                    "shader {}: sampler '{}' is none of {{nearest|linear|anisotropic}}{{Border|Clamp|Repeat|Mirror}}",
                    stage.shader.name, resource.name);
            binding.pImmutableSamplers = &static_cast<const vk::Sampler&>(**sampler);
            binding.descriptorCount = 1;
        } else {
            m_shaders.bindings.push_back(
                {resource.name, resource.kind, resource.set, resource.binding, resource.dimension});
        }
        set.push_back(binding);
    }

    void Finish() {
        for (const auto& set : m_sets)
            m_shaders.setLayouts.emplace_back(m_device.device, vk::DescriptorSetLayoutCreateInfo({}, set));
        for (const auto& layout : m_shaders.setLayouts)
            m_device.Name(layout, m_shaders.name);
    }

private:
    Device::Impl& m_device;
    ShaderInterface& m_shaders;
    std::vector<std::vector<vk::DescriptorSetLayoutBinding>> m_sets;
};

}  // namespace

vk::raii::ShaderModule MakeModule(const Device::Impl& device, const StageShader& stage) {
    vk::ShaderModuleCreateInfo info;
    info.codeSize = stage.shader.spirv.size_bytes();
    info.pCode = stage.shader.spirv.data();
    vk::raii::ShaderModule module(device.device, info);
    device.Name(module, std::string(stage.shader.name));
    return module;
}

ShaderInterface::ShaderInterface(Device::Impl& device, std::string shaderName, std::span<const StageShader> stages)
    : name(std::move(shaderName)) {
    SetBuilder sets(device, *this);
    for (const StageShader& stage : stages) {
        for (const LayoutResource& resource : stage.layout.resources) {
            if (resource.kind != ResourceKind::PushConstants) {
                sets.Add(stage, resource);
                continue;
            }
            constantsBytes = std::max(constantsBytes, resource.sizeBytes);
            constantsStages |= stage.bit;
        }
    }
    sets.Finish();
    if (constantsBytes > kMaxConstantsBytes)
        throw Error("shader {}: {} bytes of constants, at most {} fit", name, constantsBytes, kMaxConstantsBytes);

    std::vector<vk::DescriptorSetLayout> handles;
    for (const auto& set : setLayouts)
        handles.push_back(*set);
    const vk::PushConstantRange range(constantsStages, 0, constantsBytes);
    vk::PipelineLayoutCreateInfo layoutInfo({}, handles);
    if (constantsBytes > 0) layoutInfo.setPushConstantRanges(range);
    layout = vk::raii::PipelineLayout(device.device, layoutInfo);
    device.Name(layout, name);
}

}  // namespace boxcar
