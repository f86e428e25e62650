// Compiles shaders, writes what comes out and tells the user about it: the work of every command that compiles.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/bxc/manifest.h"
#include "tools/bxc/report.h"
#include "tools/bxc/workers.h"

namespace boxcar {

// Returns how many of the shaders failed. Of those the old files are removed. Throws Error if a file cannot be
// written.
size_t CompileJobs(const std::vector<ShaderJob>& jobs, const WorkerLimits& limits, Report& report);

}  // namespace boxcar
