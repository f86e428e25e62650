#include "tests/support/test_device.h"

#include <cstdlib>
#include <string_view>
#include <utility>

namespace boxcar {
namespace {

std::vector<std::string>& Messages() {
    static std::vector<std::string> messages;
    return messages;
}

}  // namespace

std::string TestDeviceSelector() {
    const char* named = std::getenv("BOXCAR_TEST_DEVICE");
    return named ? named : "llvmpipe";
}

Device& TestDevice() {
    Messages();  // outlives the device
    static Device device(DeviceDesc{
        .selector = TestDeviceSelector(), .validation = true, .onValidationMessage = [](const std::string& message) {
            Messages().push_back(message);
        }});
    return device;
}

uint32_t ValidationLayerVersion() {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    for (const VkLayerProperties& layer : layers)
        if (std::string_view(layer.layerName) == "VK_LAYER_KHRONOS_validation") return layer.specVersion;
    return 0;
}

std::vector<std::string> TakeValidationMessages() {
    return std::exchange(Messages(), {});
}

}  // namespace boxcar
