// bxc build: every shader that a manifest lists, where it is out of date.
#pragma once

#include <span>
#include <string>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/workers.h"

namespace boxcar {

struct BuildCommandOptions {
    CompileOptions everyShader;  // what every line of the manifest starts from
    std::string manifest;
    std::string outputDir;  // -o
    std::string embed;      // --embed NAME: a C++ identifier, or ""
    std::string depfile;    // --depfile FILE, or ""
    WorkerLimits limits;    // -j, --timeout, --max-memory
};

// `words` come after `build`. Throws UsageError.
BuildCommandOptions ParseBuildCommand(std::span<const std::string> words);

int RunBuildCommand(std::span<const std::string> words);
std::string BuildCommandHelp();

}  // namespace boxcar
