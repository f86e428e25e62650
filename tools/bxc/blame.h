// Explains an invalid module. It is nearly always the compiler's fault, and the validator does not know the HLSL that
// it was made from. This finds the line, and says what to write instead.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/diagnostic.h"
#include "tools/bxc/validate.h"

namespace boxcar {

// What to tell the user about a module that is not valid.
//
//   fault       what the validator says of it
//   withLines   the module of the same shader at the same step, but compiled with source lines; empty if there is
//               none. The validator runs on it again, because instructions are numbered differently in it
Diagnostic BlameCompiler(const SpirvFault& fault, ValidationStep step, const CompileOptions& options,
                         const std::vector<uint32_t>& withLines);

}  // namespace boxcar
