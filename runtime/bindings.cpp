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

void CheckDimension(const PassResources& pass, const Image& image, const char* verb, const Binding& binding,
                    const std::string& shader) {
    if (DimensionOf(image.Desc()) != binding.dimension)
        throw Error("pass '{}' gives '{}', {}, to {} as '{}' of {}, which is {}", pass.pass, image.Desc().name,
                    NameOf(DimensionOf(image.Desc())), verb, binding.name, shader, NameOf(binding.dimension));
}

const Image& FindRead(const PassResources& pass, const Binding& binding, const std::string& shader) {
    const auto read = std::ranges::find(pass.reads, binding.name, &Read::name);
    if (read == pass.reads.end())
        throw Error("pass '{}' gives nothing to read as '{}' of {}", pass.pass, binding.name, shader);
    CheckDimension(pass, *read->image, "read", binding, shader);
    return *read->image;
}

const Storage& FindStorage(const PassResources& pass, const Binding& binding, const std::string& shader) {
    const auto storage = std::ranges::find(pass.storage, binding.name, &Storage::name);
    if (storage == pass.storage.end())
        throw Error("pass '{}' gives no storage for '{}' of {}", pass.pass, binding.name, shader);
    const bool wantsBuffer = binding.kind == ResourceKind::StorageBuffer;
    if (wantsBuffer && !storage->buffer)
        throw Error("pass '{}' gives '{}', an image, as '{}' of {}, which is a buffer", pass.pass,
                    storage->image->Desc().name, binding.name, shader);
    if (wantsBuffer) return *storage;
    if (!storage->image)
        throw Error("pass '{}' gives '{}', a buffer, as '{}' of {}, which is an image", pass.pass,
                    storage->buffer->Name(), binding.name, shader);
    CheckDimension(pass, *storage->image, "write", binding, shader);
    const ImageDesc& image = storage->image->Desc();
    if (image.layers != 1 || image.levels != 1)
        throw Error(
            "pass '{}' gives '{}', which has {} layers and {} levels, to write as '{}' of {}: write an image "
            "of one and copy it",
            pass.pass, image.name, image.layers, image.levels, binding.name, shader);
    if (image.format != Format::RGBA32F && image.format != Format::R32F && image.format != Format::RGBA32UI)
        throw Error(
            "pass '{}' gives '{}', which is {}, to write as '{}' of {}: shaders write RGBA32F, R32F and "
            "RGBA32UI",
            pass.pass, image.name, FormatName(image.format), binding.name, shader);
    return *storage;
}

// Storage of one name is of no other, and is not read as a texture either.
void CheckStorageIsAlone(const PassResources& pass) {
    for (const Storage& storage : pass.storage) {
        for (const Read& read : pass.reads)
            if (storage.image && read.image == storage.image)
                throw Error("pass '{}' reads and writes '{}' at once: what it would read is undefined", pass.pass,
                            storage.image->Desc().name);
        const auto isSame = [&](const Storage& other) {
            return other.image == storage.image && other.buffer == storage.buffer;
        };
        if (std::ranges::count_if(pass.storage, isSame) > 1)
            throw Error("pass '{}' gives '{}' as storage under two names", pass.pass,
                        storage.image ? storage.image->Desc().name : storage.buffer->Name());
    }
}

void CheckConstants(const PassResources& pass, const ShaderInterface& shaders) {
    if (pass.constants.size() != shaders.constantsBytes)
        throw Error("pass '{}' has {} bytes of constants, {} takes {}", pass.pass, pass.constants.size(),
                    shaders.name, shaders.constantsBytes);
}

// What a binding is given.
struct Resource {
    const Image* image = nullptr;  // or
    const StorageBuffer* buffer = nullptr;
};

std::vector<Resource> FindResources(const ShaderInterface& shaders, const PassResources& pass) {
    CheckConstants(pass, shaders);
    CheckStorageIsAlone(pass);
    std::vector<Resource> found;
    for (const Binding& binding : shaders.bindings) {
        if (binding.kind == ResourceKind::Texture) {
            found.push_back({&FindRead(pass, binding, shaders.name), nullptr});
        } else {
            const Storage& storage = FindStorage(pass, binding, shaders.name);
            found.push_back({storage.image, storage.buffer});
        }
    }
    return found;
}

}  // namespace

std::vector<vk::DescriptorSet> CommandList::Impl::AllocateSets(const ShaderInterface& shaders) {
    std::vector<vk::DescriptorSetLayout> layouts;
    for (const auto& layout : shaders.setLayouts)
        layouts.push_back(*layout);
    if (layouts.empty()) return {};
    const auto& dispatch = *device->device.getDispatcher();
    for (const bool fresh : {false, true}) {
        if (fresh || descriptorPools.empty()) {
            const std::array sizes = {vk::DescriptorPoolSize(vk::DescriptorType::eSampledImage, 4 * kSetsPerPool),
                                      vk::DescriptorPoolSize(vk::DescriptorType::eStorageImage, 4 * kSetsPerPool),
                                      vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, 4 * kSetsPerPool),
                                      vk::DescriptorPoolSize(vk::DescriptorType::eSampler, 4 * kSetsPerPool)};
            descriptorPools.emplace_back(device->device, vk::DescriptorPoolCreateInfo({}, kSetsPerPool, sizes));
            device->Name(descriptorPools.back(), "boxcar descriptors");
        }
        std::vector<vk::DescriptorSet> sets(layouts.size());
        const vk::DescriptorSetAllocateInfo info(*descriptorPools.back(), layouts);
        const vk::Result result = (*device->device).allocateDescriptorSets(&info, sets.data(), dispatch);
        if (result != vk::Result::eSuccess) continue;
        for (const vk::DescriptorSet set : sets)
            device->Name(set, shaders.name);
        return sets;
    }
    throw Error("the device has no memory left for descriptors");
}

std::vector<vk::DescriptorSet> CommandList::Impl::Prepare(const ShaderInterface& shaders, const PassResources& pass) {
    const std::vector<Resource> resources = FindResources(shaders, pass);
    std::vector<vk::DescriptorSet> sets = AllocateSets(shaders);
    for (size_t i = 0; i < resources.size(); i++) {
        const auto [image, buffer] = resources[i];
        const Binding& binding = shaders.bindings[i];
        vk::DescriptorImageInfo imageInfo;
        vk::DescriptorBufferInfo bufferInfo;
        vk::WriteDescriptorSet write(sets[binding.set], binding.binding, 0, 1);
        if (buffer) {
            Barrier(*buffer, BufferUse::Storage);
            bufferInfo = vk::DescriptorBufferInfo(buffer->Handle(), 0, VK_WHOLE_SIZE);
            write.setDescriptorType(vk::DescriptorType::eStorageBuffer).setBufferInfo(bufferInfo);
        } else {
            const bool writes = binding.kind == ResourceKind::StorageImage;
            Barrier(*image, writes ? ImageUse::StorageReadWrite : ImageUse::ShaderRead);
            imageInfo = vk::DescriptorImageInfo({}, image->View(), image->impl().state.layout);
            write.setDescriptorType(writes ? vk::DescriptorType::eStorageImage : vk::DescriptorType::eSampledImage)
                .setImageInfo(imageInfo);
        }
        (*device->device).updateDescriptorSets(write, {}, *device->device.getDispatcher());
    }
    return sets;
}

void CommandList::Impl::Bind(vk::PipelineBindPoint point, const ShaderInterface& shaders,
                             const std::vector<vk::DescriptorSet>& sets, std::span<const std::byte> constants) {
    const auto& dispatch = *device->device.getDispatcher();
    if (!sets.empty()) commands.bindDescriptorSets(point, *shaders.layout, 0, sets, {}, dispatch);
    if (!constants.empty())
        commands.pushConstants(*shaders.layout, shaders.constantsStages, 0, shaders.constantsBytes, constants.data(),
                               dispatch);
}

}  // namespace boxcar
