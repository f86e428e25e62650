#include "samples/effects/depth_of_field.h"

#include "hlsl/constants/effect_constants.h"
#include "passes_shaders.h"

namespace boxcar {

DepthOfField::DepthOfField(Device& device, const DepthOfFieldDesc& desc)
    : m_desc(desc),
      m_pipeline(device, {passes_shaders::Find("shaders/quad.vs"), passes_shaders::Find("shaders/lens_width.ps")}),
      m_widths(device, {desc.extent, Format::RGBA32F, "circles of confusion"}),
      m_blur(device, {.extent = desc.extent,
                      .precision = desc.precision,
                      .boxes = desc.boxes,
                      .sides = desc.sides,
                      .taps = desc.taps,
                      .bias = desc.bias,
                      .codes = desc.codes}) {}

const Image& DepthOfField::Record(CommandList& commands, TexelWords color, const Image& disparity, const Lens& lens) {
    const LensConstants constants{lens.focusDisparity, lens.apertureTexels, m_desc.largestTexels};
    commands.Draw({.name = "lens",
                   .pipeline = m_pipeline,
                   .reads = {{"disparity", &disparity}},
                   .writes = {&m_widths},
                   .constants = ConstantBytes(constants)});
    return m_blur.Record(commands, color, SATWidths(m_widths, glm::vec2(1), glm::vec2(m_desc.largestTexels)));
}

}  // namespace boxcar
