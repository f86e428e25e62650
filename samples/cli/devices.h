// boxcar devices: what --device can name.
#pragma once

#include <CLI/CLI.hpp>

namespace boxcar {

void AddDevicesCommand(CLI::App& app);

}  // namespace boxcar
