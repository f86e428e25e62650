#include "tools/bxc/commands/worker.h"

#include <memory>

#include "tools/bxc/compile.h"
#include "tools/bxc/workers.h"

namespace boxcar {

int RunWorkerCommand(std::span<const std::string>) {
    const std::unique_ptr<Compiler> compiler = MakeCompiler();
    RunWorker([&](const ShaderJob& job) { return CompileShader(*compiler, job.root, job.options); });
    return 0;
}

}  // namespace boxcar
