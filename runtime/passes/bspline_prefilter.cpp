#include "runtime/passes/bspline_prefilter.h"

#include "hlsl/constants/bspline_constants.h"
#include "runtime/passes/quad_shaders.h"

namespace boxcar {

BSplinePrefilter::BSplinePrefilter(Device& device, Extent2D extent, Axis axis)
    : m_axis(axis),
      m_pipeline(device, QuadShaders("bspline_prefilter.ps")),
      m_coefficients(device, {extent, Format::RGBA32F, "coefficients"}) {}

const Image& BSplinePrefilter::Record(CommandList& commands, const Image& source) {
    const BSplinePrefilterConstants constants{m_axis == Axis::X ? int2(1, 0) : int2(0, 1)};
    commands.Draw({.name = m_axis == Axis::X ? "prefilter x" : "prefilter y",
                   .pipeline = m_pipeline,
                   .reads = {{"source", &source}},
                   .writes = {&m_coefficients},
                   .constants = ConstantBytes(constants)});
    return m_coefficients;
}

}  // namespace boxcar
