// boxcar resize and derive: pictures under third-order filters.
#pragma once

#include <CLI/CLI.hpp>

namespace boxcar {

void AddResizeCommand(CLI::App& app);
void AddDeriveCommand(CLI::App& app);

}  // namespace boxcar
