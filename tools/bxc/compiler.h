// From HLSL to SPIR-V. One interface, so that another compiler can stand behind it; today glslang does.
//
// Bindings: those of tools/layout/registers.h, or what the user's shifts make of them; spaceN is set N. A resource
// without a register gets the next free binding of its class. With -Gec a sampler is texture and sampler in one, and
// takes a t register.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/diagnostic.h"
#include "tools/bxc/source.h"

namespace boxcar {

// What the compiler makes of one entry point.
struct CompiledShader {
    // Neither legalized nor valid for Vulkan yet. Semantics are in it as decorations. Empty without an entry point.
    std::vector<uint32_t> spirv;
    std::string preprocessed;  // the source after the preprocessor, with #line where file or line jump
    bool hasEntry = false;     // false: there is no such function, which is for a rule to refuse
};

class Compiler {
public:
    virtual ~Compiler() = default;

    // Appends the compiler's messages to `diagnostics`, each one once; if it refuses the shader, at least one of
    // them is an error. Reads its files from `source`.
    virtual CompiledShader Compile(const CompileOptions& options, Source& source, Diagnostics& diagnostics) = 0;
};

// Name and version of the compiler, for --version and for the record of what made an output.
std::string CompilerVersion();

std::unique_ptr<Compiler> MakeCompiler();

}  // namespace boxcar
