// Makes SPIR-V legal for Vulkan, and fast. SPIRV-Tools does the work.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/bxc/diagnostic.h"

namespace boxcar {

// level  0: what HLSL needs to become legal SPIR-V, nothing more. 1: also smaller. 2 and 3: also faster.
// Appends what the optimizer says to `diagnostics`, about `file`; returns nothing if it fails.
std::vector<uint32_t> Optimize(const std::vector<uint32_t>& spirv, int level, const std::string& file,
                               Diagnostics& diagnostics);

// Removes the semantics, which only Reflect() needs. Drivers would need an extension for them.
std::vector<uint32_t> StripSemantics(const std::vector<uint32_t>& spirv, const std::string& file,
                                     Diagnostics& diagnostics);

}  // namespace boxcar
