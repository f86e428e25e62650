// boxcar render, sweep, inspect, list and fit-lobe: the effects without a window.
#pragma once

#include <CLI/CLI.hpp>

namespace boxcar {

void AddRenderCommand(CLI::App& app);
void AddSweepCommand(CLI::App& app);
void AddInspectCommand(CLI::App& app);
void AddListCommand(CLI::App& app);
void AddFitLobeCommand(CLI::App& app);

}  // namespace boxcar
