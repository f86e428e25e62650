// Words between tests and storage buffers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/transfer.h"
#include "tests/support/test_device.h"

namespace boxcar {

using Words = std::vector<uint32_t>;

inline StorageBuffer UploadBuffer(const Words& words, const std::string& name = "test words") {
    StorageBuffer buffer(TestDevice(), words.size() * sizeof(uint32_t), name);
    WriteBytes(TestDevice(), buffer, std::as_bytes(std::span(words)));
    return buffer;
}

inline Words DownloadBuffer(const StorageBuffer& buffer) {
    Words words(buffer.Bytes() / sizeof(uint32_t));
    ReadBytes(TestDevice(), buffer, std::as_writable_bytes(std::span(words)));
    return words;
}

}  // namespace boxcar
