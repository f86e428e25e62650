// Bytes on the device that shaders read and write: a StructuredBuffer, a ByteAddressBuffer or an RW form of them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "runtime/device.h"

namespace boxcar {

// WriteBytes and ReadBytes (runtime/transfer.h) fill it and read it back; until it is filled its bytes are undefined.
// Like an Image it remembers its last use in the order of recording. Move-only.
class StorageBuffer {
public:
    // Throws Error: no bytes; more than the device gives to one buffer, or than it has left. The message names the
    // buffer, the bytes and the limit.
    //
    //   name  for debuggers and messages
    StorageBuffer(Device& device, uint64_t bytes, const std::string& name);

    ~StorageBuffer();
    StorageBuffer(StorageBuffer&&) noexcept;
    StorageBuffer& operator=(StorageBuffer&&) noexcept;

    uint64_t Bytes() const;
    const std::string& Name() const;

    VkBuffer Handle() const;

    struct Impl;
    Impl& impl() const { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace boxcar
