// boxcar filter and boxcar sat: pictures in, pictures out.
#pragma once

#include <CLI/CLI.hpp>

namespace boxcar {

// Each adds its command to the program; the work is done while the command line is parsed.
void AddFilterCommand(CLI::App& app);
void AddSatCommand(CLI::App& app);

}  // namespace boxcar
