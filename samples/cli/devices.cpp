#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "runtime/device.h"
#include "samples/cli/commands.h"
#include "samples/cli/console.h"

namespace boxcar {
namespace {

void PrintAsJson(const std::vector<DeviceInfo>& devices) {
    auto document = nlohmann::ordered_json::array();
    for (const DeviceInfo& device : devices)
        document.push_back({{"index", device.index},
                            {"name", device.name},
                            {"kind", device.kind},
                            {"driver", device.driver},
                            {"api_version", device.apiVersion},
                            {"usable", device.unusable.empty()},
                            {"why_not", device.unusable}});
    PrintJson(document);
}

void PrintTable(const std::vector<DeviceInfo>& devices) {
    std::string text;
    for (const DeviceInfo& device : devices) {
        text += fmt::format("{}  {}\n   {}, Vulkan {}, {}\n", device.index, device.name, device.kind,
                            device.apiVersion, device.driver);
        if (!device.unusable.empty()) text += fmt::format("   cannot be used: {}\n", device.unusable);
    }
    PrintDocument(text);
}

}  // namespace

Command AddDevicesCommand(CLI::App& app) {
    const auto json = std::make_shared<bool>(false);
    CLI::App& command = *app.add_subcommand("devices", "List the Vulkan devices that --device can name");
    command.footer("Example:\n  boxcar devices --json");
    command.add_flag("--json", *json, "Print one JSON document");
    return {&command, [json] { *json ? PrintAsJson(ListDevices()) : PrintTable(ListDevices()); }};
}

}  // namespace boxcar
