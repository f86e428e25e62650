#include "tests/support/test_device.h"

#include <cstdlib>
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
    static Device device(
        DeviceDesc{.selector = TestDeviceSelector(),
                   .validation = true,
                   .onValidationMessage = [](const std::string& message) { Messages().push_back(message); }});
    return device;
}

std::vector<std::string> TakeValidationMessages() { return std::exchange(Messages(), {}); }

}  // namespace boxcar
