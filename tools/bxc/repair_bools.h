// Bools between stages, which Vulkan does not have and Direct3D has: they travel as uint, 1 for true.
#pragma once

#include "tools/bxc/spirv_module.h"

namespace boxcar {

// Makes uint, or a vector of it, of the stage's bool inputs and outputs that are no system values. Any value but 0 is
// true. Arrays of bool stay, for the validator to refuse.
void RepairBools(SpirvModule& module);

}  // namespace boxcar
