#include "runtime/compute_pipeline.h"

#include <algorithm>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

void RequireRuns(const ShaderLayout& layout, std::string_view shader, const vk::PhysicalDeviceLimits& limits) {
    if (layout.stage != ShaderStage::Compute) throw Error("shader {} is not a compute shader", shader);
    const auto& [x, y, z] = layout.threadGroup;
    const auto& most = limits.maxComputeWorkGroupSize;
    if (x > most[0] || y > most[1] || z > most[2] || uint64_t{x} * y * z > limits.maxComputeWorkGroupInvocations)
        throw Error("shader {} has groups of {} x {} x {} threads: the device runs at most {} x {} x {}, {} in all",
                    shader, x, y, z, most[0], most[1], most[2], limits.maxComputeWorkGroupInvocations);
}

}  // namespace

ComputePipeline::ComputePipeline(Device& device, const EmbeddedShader& shader) {
    Device::Impl& d = device.impl();
    const StageShader stage{shader, ShaderLayoutFromJson(shader.layoutJson), vk::ShaderStageFlagBits::eCompute};
    RequireRuns(stage.layout, shader.name, d.physicalDevice.getProperties().limits);
    m_impl.reset(new Impl{{d, std::string(shader.name), {&stage, 1}}, {}, nullptr});
    std::ranges::copy(stage.layout.threadGroup, m_impl->threadGroup.begin());

    const vk::raii::ShaderModule module = MakeModule(d, stage);
    const vk::PipelineShaderStageCreateInfo stageInfo({}, stage.bit, *module, stage.layout.entry.c_str());
    m_impl->pipeline =
        vk::raii::Pipeline(d.device, nullptr, vk::ComputePipelineCreateInfo({}, stageInfo, *m_impl->shaders.layout));
    d.Name(m_impl->pipeline, m_impl->shaders.name);
}

ComputePipeline::~ComputePipeline() = default;
ComputePipeline::ComputePipeline(ComputePipeline&&) noexcept = default;
ComputePipeline& ComputePipeline::operator=(ComputePipeline&&) noexcept = default;

ThreadGroups ComputePipeline::GroupsOver(uint32_t xThreads, uint32_t yThreads, uint32_t zThreads) const {
    const auto groups = [](uint32_t threads, uint32_t perGroup) {
        return threads / perGroup + (threads % perGroup != 0);
    };
    const auto& [x, y, z] = m_impl->threadGroup;
    return {groups(xThreads, x), groups(yThreads, y), groups(zThreads, z)};
}

}  // namespace boxcar
