// An invalid module is the compiler's fault, and never tells where it comes from: this finds the place in the HLSL,
// and knows what to write instead.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/diagnostic.h"
#include "tools/bxc/validate.h"

namespace boxcar {

// What to tell of a module that is not valid.
//
//   fault       what the validator says of it
//   withLines   the same stage's module of the same shader, compiled with source lines; empty if there is none. The
//               fault is looked for in it again, because the two differ
Diagnostic BlameCompiler(const SpirvFault& fault, ValidationStep step, const CompileOptions& options,
                         const std::vector<uint32_t>& withLines);

}  // namespace boxcar
