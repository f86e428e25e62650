// A pass that computes.
#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

void CheckGroups(const ComputePass& pass, const Device::Impl& device) {
    const auto [x, y, z] = pass.groups;
    const auto& most = device.maxThreadGroups;
    if (x < 1 || y < 1 || z < 1 || x > most[0] || y > most[1] || z > most[2])
        throw Error(
            "pass '{}' runs {} x {} x {} groups: at least 1 x 1 x 1 and, on this device, at most {} x {} x {}",
            pass.name, x, y, z, most[0], most[1], most[2]);
}

}  // namespace

void CommandList::Dispatch(const ComputePass& pass) {
    Impl& c = *m_impl;
    const ComputePipeline::Impl& pipeline = pass.pipeline.impl();
    CheckGroups(pass, *c.device);
    const PassResources resources{pass.name, pass.reads, pass.storage, pass.constants};
    const std::vector<vk::DescriptorSet> sets = c.Prepare(pipeline.shaders, resources);
    c.BeginPass(pass.name);
    c.commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline.pipeline, *c.device->device.getDispatcher());
    c.Bind(vk::PipelineBindPoint::eCompute, pipeline.shaders, sets, pass.constants);
    c.commands.dispatch(pass.groups.x, pass.groups.y, pass.groups.z, *c.device->device.getDispatcher());
    c.EndPass();
}

}  // namespace boxcar
