// One shader, from its text to SPIR-V that is proven valid. The pipeline is the list of stages in compile.cpp.
//
// Non-goals: a preprocessor, linker or optimizer of its own; ray tracing and mesh stages; Direct3D bytecode. Files
// out are the business of write.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/compiler.h"
#include "tools/bxc/diagnostic.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {

// File names are relative to the root that the shader was compiled with.
struct CompileResult {
    Diagnostics diagnostics;
    std::vector<std::string> dependencies;  // every file that was read
    std::vector<uint32_t> spirv;            // empty if there were errors
    ShaderLayout layout;
};

// Runs one shader through every stage; a stage that finds an error is the last one.
//
//   root     the folder that the paths in `options` are relative to; "" is the working folder
//   returns  what the stages made and everything that they have to say about the shader. A shader that cannot be read
//            or is wrong is an error among the diagnostics, never an exception
//
// Cost: 10 ms to seconds. A compiler that crashes or hangs takes the caller with it; CompileAll (workers.h) does not.
CompileResult CompileShader(Compiler& compiler, const std::string& root, const CompileOptions& options);

}  // namespace boxcar
