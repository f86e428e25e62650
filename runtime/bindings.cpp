// What a pass hands its shaders: checked against what they declare, put into the right state, bound.
#include <algorithm>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint32_t kSetsPerPool = 64;

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

void CheckConstants(const Pass& pass, const Pipeline::Impl& pipeline) {
    if (pass.constants.size() != pipeline.constantsBytes)
        throw Error("pass '{}' has {} bytes of constants, {} takes {}", pass.name, pass.constants.size(),
                    pipeline.name, pipeline.constantsBytes);
}

}  // namespace

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

std::vector<vk::DescriptorSet> CommandList::Impl::PrepareResources(const Pass& pass) {
    const Pipeline::Impl& pipeline = pass.pipeline.impl();
    CheckConstants(pass, pipeline);
    std::vector<vk::DescriptorSet> sets = AllocateSets(pipeline);
    for (const Binding& binding : pipeline.bindings) {
        const Image& image = FindRead(pass, binding, pipeline);
        const bool storage = binding.kind == ResourceKind::StorageImage;
        Barrier(image, storage ? ImageUse::StorageReadWrite : ImageUse::ShaderRead);
        const vk::DescriptorImageInfo info({}, image.View(), image.impl().state.layout);
        const auto type = storage ? vk::DescriptorType::eStorageImage : vk::DescriptorType::eSampledImage;
        const vk::WriteDescriptorSet write(sets[binding.set], binding.binding, 0, type, info);
        (*device->device).updateDescriptorSets(write, {}, *device->device.getDispatcher());
    }
    return sets;
}

void CommandList::Impl::Bind(const Pass& pass, const std::vector<vk::DescriptorSet>& sets) {
    const Pipeline::Impl& pipeline = pass.pipeline.impl();
    const auto& dispatch = *device->device.getDispatcher();
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.pipeline, dispatch);
    if (!sets.empty())
        commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *pipeline.layout, 0, sets, {}, dispatch);
    if (pipeline.constantsBytes > 0)
        commands.pushConstants(*pipeline.layout, pipeline.constantsStages, 0, pipeline.constantsBytes,
                               pass.constants.data(), dispatch);
}

}  // namespace boxcar
