// Runs a compute shader on the test device, which the runtime does not do yet.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tools/layout/shader_layout.h"

namespace boxcar {

// The words of a storage buffer, by its binding in set 0.
using StorageBuffers = std::map<uint32_t, std::vector<uint32_t>>;

// Runs `groups` thread groups and returns the buffers as they are afterwards.
StorageBuffers Dispatch(const EmbeddedShader& shader, StorageBuffers buffers, uint32_t groups);

}  // namespace boxcar
