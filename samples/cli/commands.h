// The commands of the program, one file each: flags are added, the command line is parsed, then the command runs.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace boxcar {

struct Command {
    CLI::App* parser;
    std::function<void()> run;  // what was parsed. Throws UsageError, Error
};

Command AddFilterCommand(CLI::App& app);
Command AddDofCommand(CLI::App& app);
Command AddSatCommand(CLI::App& app);
Command AddResizeCommand(CLI::App& app);
Command AddDeriveCommand(CLI::App& app);
Command AddPrecisionCommand(CLI::App& app);
Command AddGalleryCommand(CLI::App& app);
Command AddRenderCommand(CLI::App& app);
Command AddSweepCommand(CLI::App& app);
Command AddInspectCommand(CLI::App& app);
Command AddListCommand(CLI::App& app);
Command AddFitLobeCommand(CLI::App& app);
Command AddDevicesCommand(CLI::App& app);

}  // namespace boxcar
