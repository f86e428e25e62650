#include "runtime/passes/depth_of_field.h"

#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/quad_shaders.h"

namespace boxcar {

LensWidths::LensWidths(Device& device, Extent2D extent, float largestTexels)
    : m_largestTexels(largestTexels),
      m_pipeline(device, QuadShaders("lens_width.ps")),
      m_widths(device, {extent, Format::RGBA32F, "circles of confusion"}) {}

SATWidths LensWidths::Record(CommandList& commands, const Image& disparity, const Lens& lens) {
    const LensConstants constants{lens.focusDisparity, lens.apertureTexels, m_largestTexels};
    commands.Draw({.name = "lens",
                   .pipeline = m_pipeline,
                   .reads = {{"disparity", &disparity}},
                   .writes = {&m_widths},
                   .constants = ConstantBytes(constants)});
    return {m_widths, glm::vec2(1), glm::vec2(m_largestTexels)};
}

DepthOfField::DepthOfField(Device& device, const DepthOfFieldDesc& desc)
    : m_widths(device, desc.extent, desc.largestTexels),
      m_blur(device, {.extent = desc.extent,
                      .precision = desc.precision,
                      .boxes = desc.boxes,
                      .sides = desc.sides,
                      .taps = desc.taps,
                      .codes = desc.codes}) {}

const Image& DepthOfField::Record(CommandList& commands, TexelWords color, const Image& disparity, const Lens& lens) {
    return m_blur.Record(commands, color, m_widths.Record(commands, disparity, lens));
}

}  // namespace boxcar
