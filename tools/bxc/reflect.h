// Reads from SPIR-V what a program needs to know to run it. SPIRV-Cross does the work.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/diagnostic.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {

enum class ReflectScope {
    All,   // whatever the module holds
    Used,  // of that, what the entry point or a function it calls uses
};

// spirv  still has its semantics, as the compiler and Optimize() leave them
// Appends an error to `diagnostics` if the SPIR-V cannot be read.
ShaderLayout Reflect(const std::vector<uint32_t>& spirv, ReflectScope scope, const CompileOptions& options,
                     Diagnostics& diagnostics);

}  // namespace boxcar
