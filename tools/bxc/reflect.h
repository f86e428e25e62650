// Reads back from SPIR-V what a program needs to run it. Here SPIRV-Cross does.
#pragma once

#include "tools/bxc/compiler.h"
#include "tools/layout/shader_layout.h"

#include <cstdint>
#include <vector>

namespace boxcar {

// spirv     valid for Vulkan; what the optimiser removed is not part of the layout
// declared  the same shader as the compiler saw it: it knows the semantics, which SPIR-V does not hold
// Appends an error to `diagnostics` if SPIRV-Cross cannot read it.
ShaderLayout Reflect(const std::vector<uint32_t>& spirv, const CompiledShader& declared, Diagnostics& diagnostics);

}  // namespace boxcar
