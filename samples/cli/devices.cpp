#include "samples/cli/devices.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "runtime/device.h"

namespace boxcar {
namespace {

void PrintJson(const std::vector<DeviceInfo>& devices) {
    auto document = nlohmann::ordered_json::array();
    for (const DeviceInfo& device : devices)
        document.push_back({{"index", device.index},
                            {"name", device.name},
                            {"kind", device.kind},
                            {"driver", device.driver},
                            {"api_version", device.apiVersion},
                            {"usable", device.unusable.empty()},
                            {"why_not", device.unusable}});
    std::cout << document.dump(2) << std::endl;
}

void PrintTable(const std::vector<DeviceInfo>& devices) {
    for (const DeviceInfo& device : devices) {
        fmt::print("{}  {}\n   {}, Vulkan {}, {}\n", device.index, device.name, device.kind, device.apiVersion,
                   device.driver);
        if (!device.unusable.empty()) fmt::print("   cannot be used: {}\n", device.unusable);
    }
}

}  // namespace

void AddDevicesCommand(CLI::App& app) {
    const auto json = std::make_shared<bool>(false);
    CLI::App& command = *app.add_subcommand("devices", "List the Vulkan devices that --device can name");
    command.footer("Example:\n  boxcar devices --json");
    command.add_flag("--json", *json, "Print one JSON document");
    command.callback([json] { *json ? PrintJson(ListDevices()) : PrintTable(ListDevices()); });
}

}  // namespace boxcar
