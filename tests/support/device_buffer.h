// Words between tests and storage buffers.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "runtime/command_list.h"
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

// The words of storage buffers, by their names in the HLSL.
using NamedWords = std::map<std::string, Words, std::less<>>;

// Runs `groups` thread groups of a compute shader and returns the buffers as they are afterwards.
inline NamedWords RunCompute(const EmbeddedShader& shader, NamedWords buffers, uint32_t groups) {
    const ComputePipeline pipeline(TestDevice(), shader);
    std::map<std::string_view, StorageBuffer> uploaded;
    std::vector<Storage> storage;
    for (const auto& [name, words] : buffers)
        storage.emplace_back(name, &uploaded.emplace(name, UploadBuffer(words, name)).first->second);
    CommandList commands(TestDevice());
    commands.Dispatch({.name = shader.name, .pipeline = pipeline, .storage = storage, .groups = {groups}});
    commands.SubmitAndWait();
    for (auto& [name, words] : buffers)
        words = DownloadBuffer(uploaded.at(name));
    return buffers;
}

}  // namespace boxcar
