// Private to runtime/: the Vulkan objects behind the public classes. Precompiled, because vulkan_raii.hpp costs
// seconds in every file that includes it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "runtime/command_list.h"
#include "runtime/device.h"
#include "runtime/image.h"
#include "runtime/mesh.h"
#include "runtime/pipeline.h"
#include "runtime/storage_buffer.h"

namespace boxcar {

struct Device::Impl {
    explicit Impl(vk::raii::Context&& loaded) : context(std::move(loaded)) {}

    vk::raii::Context context;
    vk::raii::Instance instance = nullptr;
    vk::raii::DebugUtilsMessengerEXT messenger = nullptr;
    vk::raii::PhysicalDevice physicalDevice = nullptr;
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;
    uint32_t queueFamily = 0;
    bool hasDebugUtils = false;
    bool hasSamplerAnisotropy = false;
    float maxAnisotropy = 1;  // of samplers; 1 where the device was made without

    DeviceInfo info;
    DeviceLimits limits;
    uint64_t maxStorageBytes = 0;  // of one buffer
    std::array<uint32_t, 3> maxThreadGroups{};
    vk::PhysicalDeviceMemoryProperties memory;
    double nanosecondsPerTick = 0;  // 0: no timer
    uint64_t memoryBytes = 0;
    uint64_t peakMemoryBytes = 0;
    std::function<void(const std::string&)> onValidationMessage;

    std::optional<vk::raii::CommandPool> commandPool;
    std::vector<vk::raii::CommandBuffer> idleCommands;  // recorded anew by the next list rather than freed
    std::map<std::string, vk::raii::Sampler, std::less<>> samplers;  // by their names in the HLSL

    // Everything that needs no more than the handles: limits, timer, pool.
    void Finish();

    // An index into memory.memoryTypes with all of `flags`, or nothing.
    std::optional<uint32_t> MemoryType(uint32_t typeBits, vk::MemoryPropertyFlags flags) const;

    // Counts bytes in and, negative, out.
    void CountMemory(int64_t bytes);

    // For debuggers; takes handles and their owners.
    template <typename Handle>
    void Name(const Handle& handle, const std::string& name) const {
        if constexpr (requires { handle.getDispatcher(); }) {  // vk::raii
            Name(*handle, name);
        } else if (hasDebugUtils && !name.empty()) {
            const auto number = reinterpret_cast<uint64_t>(static_cast<typename Handle::CType>(handle));
            device.setDebugUtilsObjectNameEXT({Handle::objectType, number, name.c_str()});
        }
    }

    // The sampler of a name, made when first asked for; nullptr for a name that says nothing.
    const vk::raii::Sampler* FindSampler(std::string_view name);
};

// Where an image stands in the order of recorded commands.
struct ImageState {
    vk::ImageLayout layout = vk::ImageLayout::eUndefined;
    vk::PipelineStageFlags2 stages = vk::PipelineStageFlagBits2::eNone;
    vk::AccessFlags2 access = vk::AccessFlagBits2::eNone;
};

struct Image::Impl {
    Device::Impl* device = nullptr;
    ImageDesc desc;
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::Image ownImage = nullptr;
    vk::raii::ImageView ownView = nullptr;
    vk::Image image;
    vk::ImageView view;
    uint64_t memoryBytes = 0;
    ImageState state;
};

// A buffer with memory of its own, which is counted; mapped for as long as it lives where the host sees it.
class Buffer {
public:
    // Throws Error: the device has no memory left. The message names the buffer.
    Buffer(Device::Impl& device, uint64_t bytes, vk::BufferUsageFlags usage, vk::MemoryPropertyFlags properties,
           const std::string& name);
    ~Buffer();
    Buffer(Buffer&&) = delete;

    vk::Buffer Handle() const { return *m_buffer; }
    std::byte* Mapped() const { return m_mapped; }

private:
    Device::Impl& m_device;
    vk::raii::Buffer m_buffer;
    vk::raii::DeviceMemory m_memory = nullptr;
    std::byte* m_mapped = nullptr;
    uint64_t m_bytes = 0;
};

enum class BufferUse { Storage, TransferSource, TransferTarget };

// As an image's, without a layout.
struct BufferState {
    vk::PipelineStageFlags2 stages = vk::PipelineStageFlagBits2::eNone;
    vk::AccessFlags2 access = vk::AccessFlagBits2::eNone;
};

struct StorageBuffer::Impl {
    Buffer buffer;
    uint64_t bytes = 0;
    std::string name;
    BufferState state;
};

struct Mesh::Impl {
    Buffer buffer;  // vertices, then indices
    uint64_t indicesOffsetBytes = 0;
    uint32_t indexCount = 0;
};

// A resource of a shader, by name, and where its descriptor lives.
struct Binding {
    std::string name;
    ResourceKind kind = ResourceKind::Texture;
    uint32_t set = 0;
    uint32_t binding = 0;
    TextureDimension dimension = TextureDimension::Flat;
};

struct StageShader {
    const EmbeddedShader& shader;
    ShaderLayout layout;
    vk::ShaderStageFlagBits bit;
};

vk::raii::ShaderModule MakeModule(const Device::Impl& device, const StageShader& stage);

// What all shaders of a pipeline together take.
struct ShaderInterface {
    // Throws Error: a resource of a kind or a sampler of a name that the runtime does not know; constants over 128
    // bytes.
    ShaderInterface(Device::Impl& device, std::string name, std::span<const StageShader> stages);

    std::string name;
    std::vector<Binding> bindings;  // that a pass has to name: samplers are fixed
    uint32_t constantsBytes = 0;
    vk::ShaderStageFlags constantsStages;
    std::vector<vk::raii::DescriptorSetLayout> setLayouts;
    vk::raii::PipelineLayout layout = nullptr;
};

struct Pipeline::Impl {
    ShaderInterface shaders;
    std::vector<Format> targets;
    bool drawsMesh = false;
    bool testsDepth = false;
    vk::raii::Pipeline pipeline = nullptr;
};

struct ComputePipeline::Impl {
    ShaderInterface shaders;
    std::array<uint32_t, 3> threadGroup{};
    vk::raii::Pipeline pipeline = nullptr;
};

// What a pass of either kind gives its shaders.
struct PassResources {
    std::string_view pass;  // its name
    std::span<const Read> reads;
    std::span<const Storage> storage;
    std::span<const std::byte> constants;
};

// Measures passes with pairs of timestamps, in as many pools of them as the passes need.
class PassTimer {
public:
    // `device` has a timer.
    explicit PassTimer(Device::Impl& device) : m_device(&device) {}

    // Both are recorded outside of rendering.
    void Begin(vk::CommandBuffer commands, const std::string& pass);
    void End(vk::CommandBuffer commands) const;

    // Of all passes, after their work is done.
    std::vector<PassTime> Times() const;

private:
    Device::Impl* m_device;
    std::vector<vk::raii::QueryPool> m_pools;
    std::vector<std::string> m_names;
};

struct CommandList::Impl {
    Device::Impl* device = nullptr;
    vk::raii::CommandBuffer own = nullptr;
    bool isPending = false;  // submitted, and not known to be done
    vk::CommandBuffer commands;
    std::vector<vk::raii::DescriptorPool> descriptorPools;
    std::optional<PassTimer> timer;
    std::vector<PassTime> times;

    ~Impl();

    // Around the commands of a pass: its label for debuggers, and its timer.
    void BeginPass(std::string_view name);
    void EndPass();

    void Barrier(const Image& image, ImageUse use);
    void Barrier(const StorageBuffer& buffer, BufferUse use);

    // Checks the resources against what the shaders take, and records their barriers. Outside of rendering.
    std::vector<vk::DescriptorSet> Prepare(const ShaderInterface& shaders, const PassResources& pass);
    void Bind(vk::PipelineBindPoint point, const ShaderInterface& shaders, const std::vector<vk::DescriptorSet>& sets,
              std::span<const std::byte> constants);

    std::vector<vk::DescriptorSet> AllocateSets(const ShaderInterface& shaders);
};

vk::Format VulkanFormat(Format format);

// `rgba` as the format holds it.
vk::ClearColorValue ClearValue(const glm::vec4& rgba, Format format);

inline vk::ImageAspectFlagBits AspectOf(Format format) {
    return format == Format::Depth32F ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
}

}  // namespace boxcar
