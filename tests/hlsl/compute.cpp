#include "tests/hlsl/compute.h"

#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>

#include "tests/support/test_device.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

void Check(VkResult result) {
    if (result != VK_SUCCESS) throw Error("Vulkan result {}", static_cast<int>(result));
}

template <typename Info>
Info Make(VkStructureType type) {
    Info info{};
    info.sType = type;
    return info;
}

// What is destroyed at the end, last first.
class Cleanup {
public:
    ~Cleanup() {
        std::for_each(m_steps.rbegin(), m_steps.rend(), [](const auto& step) { step(); });
    }
    void Add(std::function<void()> step) { m_steps.push_back(std::move(step)); }

private:
    std::vector<std::function<void()>> m_steps;
};

struct MappedBuffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    void* bytes = nullptr;
};

MappedBuffer MakeBuffer(const AdoptedDevice& on, VkDeviceSize size, Cleanup& cleanup) {
    MappedBuffer result;
    auto info = Make<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = size;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    Check(vkCreateBuffer(on.device, &info, nullptr, &result.buffer));
    cleanup.Add([=] { vkDestroyBuffer(on.device, result.buffer, nullptr); });

    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(on.device, result.buffer, &needs);
    VkPhysicalDeviceMemoryProperties memories;
    vkGetPhysicalDeviceMemoryProperties(on.physicalDevice, &memories);
    constexpr VkMemoryPropertyFlags kWanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    auto allocation = Make<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    allocation.allocationSize = needs.size;
    while ((needs.memoryTypeBits >> allocation.memoryTypeIndex & 1) == 0 ||
           (memories.memoryTypes[allocation.memoryTypeIndex].propertyFlags & kWanted) != kWanted)
        ++allocation.memoryTypeIndex;
    VkDeviceMemory memory;
    Check(vkAllocateMemory(on.device, &allocation, nullptr, &memory));
    cleanup.Add([=] { vkFreeMemory(on.device, memory, nullptr); });
    Check(vkBindBufferMemory(on.device, result.buffer, memory, 0));
    Check(vkMapMemory(on.device, memory, 0, VK_WHOLE_SIZE, 0, &result.bytes));
    return result;
}

}  // namespace

StorageBuffers Dispatch(const EmbeddedShader& shader, StorageBuffers buffers, uint32_t groups) {
    const AdoptedDevice on = TestDevice().Handles();
    Cleanup cleanup;

    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const auto& [binding, words] : buffers)
        bindings.push_back({binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    auto setInfo = Make<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    setInfo.bindingCount = static_cast<uint32_t>(bindings.size());
    setInfo.pBindings = bindings.data();
    VkDescriptorSetLayout setLayout;
    Check(vkCreateDescriptorSetLayout(on.device, &setInfo, nullptr, &setLayout));
    cleanup.Add([=] { vkDestroyDescriptorSetLayout(on.device, setLayout, nullptr); });

    auto layoutInfo = Make<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    layoutInfo.setLayoutCount = 1;
    layoutInfo.pSetLayouts = &setLayout;
    VkPipelineLayout layout;
    Check(vkCreatePipelineLayout(on.device, &layoutInfo, nullptr, &layout));
    cleanup.Add([=] { vkDestroyPipelineLayout(on.device, layout, nullptr); });

    auto moduleInfo = Make<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    moduleInfo.codeSize = shader.spirv.size_bytes();
    moduleInfo.pCode = shader.spirv.data();
    VkShaderModule module;
    Check(vkCreateShaderModule(on.device, &moduleInfo, nullptr, &module));
    cleanup.Add([=] { vkDestroyShaderModule(on.device, module, nullptr); });

    const std::string entry = ShaderLayoutFromJson(shader.layoutJson).entry;
    auto pipelineInfo = Make<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    pipelineInfo.stage = Make<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    pipelineInfo.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    pipelineInfo.stage.module = module;
    pipelineInfo.stage.pName = entry.c_str();
    pipelineInfo.layout = layout;
    VkPipeline pipeline;
    Check(vkCreateComputePipelines(on.device, VK_NULL_HANDLE, 1, &pipelineInfo, nullptr, &pipeline));
    cleanup.Add([=] { vkDestroyPipeline(on.device, pipeline, nullptr); });

    const VkDescriptorPoolSize poolSize{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, setInfo.bindingCount};
    auto descriptorPoolInfo = Make<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    descriptorPoolInfo.maxSets = 1;
    descriptorPoolInfo.poolSizeCount = 1;
    descriptorPoolInfo.pPoolSizes = &poolSize;
    VkDescriptorPool descriptorPool;
    Check(vkCreateDescriptorPool(on.device, &descriptorPoolInfo, nullptr, &descriptorPool));
    cleanup.Add([=] { vkDestroyDescriptorPool(on.device, descriptorPool, nullptr); });
    auto setAllocation = Make<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    setAllocation.descriptorPool = descriptorPool;
    setAllocation.descriptorSetCount = 1;
    setAllocation.pSetLayouts = &setLayout;
    VkDescriptorSet set;
    Check(vkAllocateDescriptorSets(on.device, &setAllocation, &set));

    std::map<uint32_t, void*> mapped;
    for (const auto& [binding, words] : buffers) {
        const size_t bytes = words.size() * sizeof(uint32_t);
        const MappedBuffer buffer = MakeBuffer(on, bytes, cleanup);
        std::memcpy(buffer.bytes, words.data(), bytes);
        mapped[binding] = buffer.bytes;
        const VkDescriptorBufferInfo info{buffer.buffer, 0, VK_WHOLE_SIZE};
        auto write = Make<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
        write.dstSet = set;
        write.dstBinding = binding;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &info;
        vkUpdateDescriptorSets(on.device, 1, &write, 0, nullptr);
    }

    auto poolInfo = Make<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    poolInfo.queueFamilyIndex = on.queueFamily;
    VkCommandPool pool;
    Check(vkCreateCommandPool(on.device, &poolInfo, nullptr, &pool));
    cleanup.Add([=] { vkDestroyCommandPool(on.device, pool, nullptr); });
    auto commandsInfo = Make<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    commandsInfo.commandPool = pool;
    commandsInfo.commandBufferCount = 1;
    VkCommandBuffer commands;
    Check(vkAllocateCommandBuffers(on.device, &commandsInfo, &commands));

    auto begin = Make<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    Check(vkBeginCommandBuffer(commands, &begin));
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
    vkCmdDispatch(commands, groups, 1, 1);
    auto toHost = Make<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    toHost.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    toHost.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &toHost, 0,
                         nullptr, 0, nullptr);
    Check(vkEndCommandBuffer(commands));
    auto submit = Make<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    Check(vkQueueSubmit(on.queue, 1, &submit, VK_NULL_HANDLE));
    Check(vkQueueWaitIdle(on.queue));

    for (auto& [binding, words] : buffers)
        std::memcpy(words.data(), mapped[binding], words.size() * sizeof(uint32_t));
    return buffers;
}

}  // namespace boxcar
