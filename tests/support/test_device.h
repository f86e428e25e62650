// The device of a test program. It runs under the validation layer with synchronization validation, and a message
// fails the test during which it came (support/main.cpp).
#pragma once

#include <string>
#include <vector>

#include "runtime/device.h"

namespace boxcar {

// Lavapipe, or what BOXCAR_TEST_DEVICE names: an index or a part of the name.
std::string TestDeviceSelector();

Device& TestDevice();

// The version of the installed validation layer, as VK_MAKE_API_VERSION makes it; it varies in what it can see.
uint32_t ValidationLayerVersion();

// What the validation layer has said since this was last called.
std::vector<std::string> TakeValidationMessages();

}  // namespace boxcar
