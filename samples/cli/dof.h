// boxcar dof: depth of field on a photograph.
#pragma once

#include <CLI/CLI.hpp>

namespace boxcar {

void AddDofCommand(CLI::App& app);

}  // namespace boxcar
