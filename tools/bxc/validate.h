// Proves that SPIR-V follows the rules of Vulkan 1.1. SPIRV-Tools does the work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace boxcar {

enum class ValidationStep {
    BeforeLegalization,  // allows what HLSL leaves for the optimizer to put right, such as copies of textures
    Final,               // as strict as a Vulkan driver may be
};

struct SpirvFault {
    std::string text;        // what the validator says, in one line
    size_t instruction = 0;  // number of the instruction, from 1; 0 where it does not tell
};

// The first thing that is wrong, if anything is.
std::optional<SpirvFault> FindFault(const std::vector<uint32_t>& spirv, ValidationStep step);

}  // namespace boxcar
