// Texels up, passes run, texels down: what every command does with the device.
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <vector>

#include "runtime/command_list.h"

namespace boxcar {

struct DeviceRun {
    std::vector<glm::vec4> texels;
    std::vector<PassTime> passes;
    uint64_t deviceBytes = 0;  // held for it
};

// `record` appends passes that read its image and returns the one to bring back, RGBA32F and of the same extent.
using RecordPasses = std::function<const Image&(CommandList& commands, const Image& source)>;

// `texels`: rows from the top. What `record` uses must outlive the call.
DeviceRun RunOnDevice(Device& device, Extent2D extent, std::vector<glm::vec4> texels, const RecordPasses& record);

}  // namespace boxcar
