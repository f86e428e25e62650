#include "samples/cli/stats.h"

#include <fmt/format.h>

namespace boxcar {
namespace {

double TotalMilliseconds(const Stats& stats) {
    double total = 0;
    for (const PassTime& pass : stats.passes)
        total += pass.milliseconds;
    return total;
}

}  // namespace

nlohmann::ordered_json ToJson(const Stats& stats) {
    nlohmann::ordered_json json = {{"input", stats.input},
                                   {"output", stats.output},
                                   {"width", stats.extent.widthTexels},
                                   {"height", stats.extent.heightTexels},
                                   {"precision", stats.precision},
                                   {"table_bytes", stats.tableBytes},
                                   {"device_bytes", stats.deviceBytes},
                                   {"device_ms", TotalMilliseconds(stats)}};
    json["passes"] = nlohmann::ordered_json::array();
    for (const PassTime& pass : stats.passes)
        json["passes"].push_back({{"name", pass.name}, {"ms", pass.milliseconds}});
    return json;
}

void PrintStats(const Stats& stats, const DeviceInfo& device) {
    fmt::print(stderr, "{} -> {}: {} x {}\n  device   {}, {}\n", stats.input, stats.output, stats.extent.widthTexels,
               stats.extent.heightTexels, device.name, device.driver);
    if (!stats.volume.empty()) fmt::print(stderr, "  volume   {}\n", stats.volume);
    for (const PassTime& pass : stats.passes)
        fmt::print(stderr, "  {:14} {:9.3f} ms\n", pass.name, pass.milliseconds);
    const auto mebibytes = [](uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); };
    fmt::print(stderr, "  {} passes {:.3f} ms; device memory {:.1f} MiB", stats.passes.size(),
               TotalMilliseconds(stats), mebibytes(stats.deviceBytes));
    if (stats.tableBytes > 0)
        fmt::print(stderr, ", {:.1f} MiB of it the {} table's", mebibytes(stats.tableBytes), stats.precision);
    fmt::print(stderr, "\n");
}

}  // namespace boxcar
