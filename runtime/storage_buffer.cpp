#include "runtime/storage_buffer.h"

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

uint64_t RequireFits(const Device::Impl& device, uint64_t bytes, const std::string& name) {
    if (bytes < 1 || bytes > device.maxStorageBytes)
        throw Error("buffer '{}' of {} bytes: the device takes 1 to {}", name, bytes, device.maxStorageBytes);
    return bytes;
}

}  // namespace

StorageBuffer::StorageBuffer(Device& device, uint64_t bytes, const std::string& name)
    : m_impl(new Impl{{device.impl(), RequireFits(device.impl(), bytes, name),
                       vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferSrc |
                           vk::BufferUsageFlagBits::eTransferDst,
                       vk::MemoryPropertyFlagBits::eDeviceLocal, fmt::format("buffer '{}'", name)},
                      bytes,
                      name,
                      {}}) {}

StorageBuffer::~StorageBuffer() = default;
StorageBuffer::StorageBuffer(StorageBuffer&&) noexcept = default;
StorageBuffer& StorageBuffer::operator=(StorageBuffer&&) noexcept = default;

uint64_t StorageBuffer::Bytes() const {
    return m_impl->bytes;
}
const std::string& StorageBuffer::Name() const {
    return m_impl->name;
}
VkBuffer StorageBuffer::Handle() const {
    return m_impl->buffer.Handle();
}

}  // namespace boxcar
