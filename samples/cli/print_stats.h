// Stats for people (--stats) and programs (--json).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "runtime/device.h"
#include "samples/app/stats.h"

namespace boxcar {

// {"input", "output", "width", "height", "precision", "step", "rounds", "table_bytes", "device_bytes", "device_ms",
// "passes": [{"name", "ms"}]}; precision and step are null where no table was needed.
nlohmann::ordered_json ToJson(const Stats& stats);

// To stderr, so that a picture may go to stdout.
void PrintStats(const Stats& stats, const DeviceInfo& device);

}  // namespace boxcar
