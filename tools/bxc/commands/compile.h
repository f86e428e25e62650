// bxc compile: one shader.
#pragma once

#include <span>
#include <string>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/workers.h"

namespace boxcar {

struct CompileCommandOptions {
    CompileOptions shader;  // `output` is the .spv file, or "" where only a header is written
    WorkerLimits limits;
};

// `words` come after `compile`. Throws UsageError.
CompileCommandOptions ParseCompileCommand(std::span<const std::string> words);

int RunCompileCommand(std::span<const std::string> words);
std::string CompileCommandHelp();

}  // namespace boxcar
