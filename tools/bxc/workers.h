// Runs compiles in processes of their own, so that a compiler which crashes, hangs or devours the memory takes one
// shader with it and not the build.
#pragma once

#include <functional>
#include <vector>

#include "tools/bxc/compile.h"
#include "tools/bxc/manifest.h"

namespace boxcar {

struct WorkerLimits {
    int workers = 0;          // processes at a time; 0 is one a core
    int timeoutSeconds = 60;  // of one shader
    int maxMemoryMib = 1024;  // resident size of one worker
};

// Compiles all jobs and calls `done` for each, in the order of the jobs. A worker that dies or breaks a limit is
// replaced, and its shader gets one error that says so. Throws Error if no process can be started.
void CompileAll(const std::vector<ShaderJob>& jobs, const WorkerLimits& limits,
                const std::function<void(const ShaderJob&, CompileResult)>& done);

// The other side: `bxc worker`, which CompileAll starts. Takes jobs from stdin and answers on stdout, until stdin
// ends.
void RunWorker(const std::function<CompileResult(const ShaderJob&)>& compile);

}  // namespace boxcar
