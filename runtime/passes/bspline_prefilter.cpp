#include "runtime/passes/bspline_prefilter.h"

#include "hlsl/constants/bspline_constants.h"
#include "runtime/passes/quad_shaders.h"

namespace boxcar {

BSplinePrefilter::BSplinePrefilter(Device& device, Extent2D extent)
    : m_pipeline(device, QuadShaders("bspline_prefilter.ps")),
      m_alongX(device, {extent, Format::RGBA32F, "coefficients along x"}),
      m_coefficients(device, {extent, Format::RGBA32F, "coefficients"}) {}

const Image& BSplinePrefilter::Record(CommandList& commands, const Image& source) {
    const auto along = [&](const Image& from, const Image& to, int2 stepTexels) {
        const BSplinePrefilterConstants constants{stepTexels};
        commands.Draw({.name = "prefilter",
                       .pipeline = m_pipeline,
                       .reads = {{"source", &from}},
                       .writes = {&to},
                       .constants = ConstantBytes(constants)});
    };
    along(source, m_alongX, {1, 0});
    along(m_alongX, m_coefficients, {0, 1});
    return m_coefficients;
}

}  // namespace boxcar
