#include "runtime/passes/sat_verbatim_blur.h"

#include "hlsl/constants/sat_constants.h"
#include "runtime/passes/quad_shaders.h"

namespace boxcar {

SatVerbatimBlur::SatVerbatimBlur(Device& device, Extent2D extent)
    : m_pipeline(device, QuadShaders("sat_blur_verbatim.ps")),
      m_result(device, {extent, Format::RGBA32F, "verbatim blur"}) {}

const Image& SatVerbatimBlur::Record(CommandList& commands, const Image& table, glm::vec2 sizeTexels) {
    const auto [width, height] = m_result.Extent();
    SATFilterConstants constants{};
    constants.extentTexels = int2(width, height);
    constants.minTexels = sizeTexels;
    commands.Draw({.name = "verbatim blur",
                   .pipeline = m_pipeline,
                   .reads = {{"table", &table}},
                   .writes = {&m_result},
                   .constants = ConstantBytes(constants)});
    return m_result;
}

}  // namespace boxcar
