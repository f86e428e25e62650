// bxc worker: the process that compiles. CompileAll (workers.h) starts it; people do not.
#pragma once

#include <span>
#include <string>

namespace boxcar {

int RunWorkerCommand(std::span<const std::string> words);

}  // namespace boxcar
