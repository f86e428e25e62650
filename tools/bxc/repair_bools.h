// Bools between stages. Direct3D has them and Vulkan does not, so they are passed as uint, 1 for true.
#pragma once

#include "tools/bxc/spirv_module.h"

namespace boxcar {

// Turns the stage's bool inputs and outputs into uint, and vectors of bool into vectors of uint, except for system
// values. Any value except for 0 is true. Arrays of bool are left for the validator to refuse.
void RepairBools(SpirvModule& module);

}  // namespace boxcar
