// What the picture commands have in common: inputs -> outputs on one device, with progress, --stats and --json.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "samples/cli/options.h"
#include "samples/cli/outputs.h"
#include "samples/cli/print_stats.h"

namespace boxcar {

struct BatchOptions {
    OutputOptions files;
    DeviceOptions device;
    ReadOptions read;
    bool stats = false;
    bool json = false;
};

void AddBatchOptions(CLI::App& command, BatchOptions& options);

// Does one job and says what the device did. Throws Error.
using Work = std::function<Stats(Device&, const Job&)>;

// Runs `work` for each input. An input that fails is reported and the others go on; then this throws Error.
void RunBatch(const std::string& command, const BatchOptions& options, const std::vector<Job>& jobs,
              const Work& work);

}  // namespace boxcar
