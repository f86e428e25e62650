#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {

Buffer::Buffer(Device::Impl& device, uint64_t bytes, vk::BufferUsageFlags usage, vk::MemoryPropertyFlags properties,
               const std::string& name)
    : m_device(device), m_buffer(device.device, vk::BufferCreateInfo({}, bytes, usage)) {
    const vk::MemoryRequirements needs = m_buffer.getMemoryRequirements();
    auto type = device.MemoryType(needs.memoryTypeBits, properties);
    if (!type) type = device.MemoryType(needs.memoryTypeBits, {});  // never for staging: Vulkan promises its kind
    try {
        m_memory = vk::raii::DeviceMemory(device.device, vk::MemoryAllocateInfo(needs.size, type.value()));
    } catch (const vk::SystemError& error) {
        throw Error("{} takes {} bytes: the device, which holds {} already, has no more ({})", name, needs.size,
                    device.memoryBytes, error.what());
    }
    m_buffer.bindMemory(*m_memory, 0);
    if (properties & vk::MemoryPropertyFlagBits::eHostVisible)
        m_mapped = static_cast<std::byte*>(m_memory.mapMemory(0, VK_WHOLE_SIZE));
    device.Name(m_buffer, name);
    device.Name(m_memory, name);
    m_bytes = needs.size;
    device.CountMemory(static_cast<int64_t>(m_bytes));
}

Buffer::~Buffer() {
    m_device.CountMemory(-static_cast<int64_t>(m_bytes));
}

}  // namespace boxcar
