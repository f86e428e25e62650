// Proves that SPIR-V keeps the rules of Vulkan 1.1. Here SPIRV-Tools does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/bxc/diagnostic.h"

namespace boxcar {

enum class ValidationStep {
    BeforeLegalization,  // allows what HLSL leaves for the optimiser to put right, such as copies of textures
    Final,               // as strict as a Vulkan driver may be
};

// Appends what is wrong to `diagnostics`, as errors about `file`.
void Validate(const std::vector<uint32_t>& spirv, ValidationStep step, const std::string& file,
              Diagnostics& diagnostics);

}  // namespace boxcar
