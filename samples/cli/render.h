// boxcar render, sweep, inspect and list: the effects without a window.
#pragma once

#include <CLI/CLI.hpp>

namespace boxcar {

void AddRenderCommand(CLI::App& app);
void AddSweepCommand(CLI::App& app);
void AddInspectCommand(CLI::App& app);
void AddListCommand(CLI::App& app);

}  // namespace boxcar
