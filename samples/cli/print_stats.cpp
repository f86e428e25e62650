#include "samples/cli/print_stats.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/base/printable.h"

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
                                   {"step", stats.step},
                                   {"rounds", stats.rounds},
                                   {"table_bytes", stats.tableBytes},
                                   {"device_bytes", stats.deviceBytes},
                                   {"device_ms", TotalMilliseconds(stats)}};
    if (stats.precision.empty()) json["precision"] = json["step"] = nullptr;
    json["passes"] = nlohmann::ordered_json::array();
    for (const PassTime& pass : stats.passes)
        json["passes"].push_back({{"name", pass.name}, {"ms", pass.milliseconds}});
    return json;
}

void PrintStats(const Stats& stats, const DeviceInfo& device) {
    fmt::print(stderr, "{} -> {}: {} x {}\n  device   {}, {}\n", Printable(stats.input), Printable(stats.output),
               stats.extent.widthTexels, stats.extent.heightTexels, device.name, device.driver);
    if (!stats.volume.empty()) fmt::print(stderr, "  volume   {}\n", Printable(stats.volume));
    for (const PassTime& pass : stats.passes)
        fmt::print(stderr, "  {:14} {:9.3f} ms\n", pass.name, pass.milliseconds);
    const auto mebibytes = [](uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); };
    fmt::print(stderr, "  {} passes {:.3f} ms; device memory {:.1f} MiB", stats.passes.size(),
               TotalMilliseconds(stats), mebibytes(stats.deviceBytes));
    if (stats.tableBytes > 0)
        fmt::print(stderr, ", {:.1f} MiB of it the {} table's", mebibytes(stats.tableBytes), stats.precision);
    if (stats.step > 0) fmt::print(stderr, "; in steps of {:.3g}", stats.step);
    if (stats.rounds > 1) fmt::print(stderr, ", in {} rounds", stats.rounds);
    fmt::print(stderr, "\n");
}

}  // namespace boxcar
