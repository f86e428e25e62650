#include "samples/cli/device_run.h"

#include "runtime/transfer.h"

namespace boxcar {

DeviceRun RunOnDevice(Device& device, Extent2D extent, std::vector<glm::vec4> texels, const RecordPasses& record) {
    const Image source(device, {extent, Format::RGBA32F, "source"});
    WriteTexels(device, source, std::as_bytes(std::span(texels)));
    CommandList commands(device, CommandList::Timing::On);
    const Image& result = record(commands, source);
    commands.SubmitAndWait();
    ReadTexels(device, result, std::as_writable_bytes(std::span(texels)));
    return {std::move(texels), commands.PassTimes(), device.MemoryBytes()};
}

}  // namespace boxcar
