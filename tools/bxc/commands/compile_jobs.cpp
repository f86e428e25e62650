#include "tools/bxc/commands/compile_jobs.h"

#include "tools/bxc/write.h"

namespace boxcar {

size_t CompileJobs(const std::vector<ShaderJob>& jobs, const WorkerLimits& limits, Report& report) {
    const FileTime started = Now();
    size_t done = 0, failed = 0;
    CompileAll(jobs, limits, [&](const ShaderJob& job, const CompileResult& result) {
        report.Add(result.diagnostics, job.root);
        if (HasErrors(result.diagnostics)) {
            RemoveOutputs(job);
            ++failed;
        } else {
            WriteOutputs(job, result, started);
        }
        report.Progress(++done, jobs.size(), job.options.output);
    });
    return failed;
}

}  // namespace boxcar
