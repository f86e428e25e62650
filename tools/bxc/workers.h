// Compiles in separate processes, so that a compiler that crashes, hangs or uses up the memory costs one shader and
// not the whole build.
#pragma once

#include <functional>
#include <vector>

#include "tools/bxc/compile.h"
#include "tools/bxc/manifest.h"

namespace boxcar {

struct WorkerLimits {
    int workers = 0;          // processes at a time; 0 is one per core
    int timeoutSeconds = 60;  // of one shader
    int maxMemoryMib = 1024;  // resident size of one worker
};

// Compiles all jobs and calls `done` for each, in the order of the jobs. A worker that dies or goes over a limit is
// replaced, and its shader gets one error that says so. Throws Error if no process can be started.
void CompileAll(const std::vector<ShaderJob>& jobs, const WorkerLimits& limits,
                const std::function<void(const ShaderJob&, CompileResult)>& done);

// The other side: `bxc worker`, which CompileAll starts. Takes jobs from stdin and answers on stdout, until stdin
// ends.
void RunWorker(const std::function<CompileResult(const ShaderJob&)>& compile);

}  // namespace boxcar
