#include "samples/effects/box_blur.h"

namespace boxcar {

BoxBlur::BoxBlur(Device& device, const BoxBlurDesc& desc)
    : m_table(device, {.extent = desc.extent, .taps = desc.taps, .bias = desc.bias}),
      m_filter(device, {.extent = desc.extent, .edge = desc.edge, .bias = desc.bias}) {}

const Image& BoxBlur::Record(CommandList& commands, const Image& source, glm::vec2 sizeTexels) {
    return m_filter.Record(commands, m_table.Record(commands, source), sizeTexels);
}

}  // namespace boxcar
