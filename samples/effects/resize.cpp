#include "samples/effects/resize.h"

#include <algorithm>
#include <glm/common.hpp>

#include "hlsl/boxcar/sat_range.h"
#include "hlsl/constants/bspline_constants.h"
#include "passes_shaders.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

const char* ShaderOf(ResizeFilter filter) {
    switch (filter) {
        case ResizeFilter::Nearest: return "shaders/resize.ps.FILTER=NEAREST";
        case ResizeFilter::Linear: return "shaders/resize.ps.FILTER=LINEAR";
        case ResizeFilter::CatmullRom: return "shaders/resize.ps.FILTER=CATMULL_ROM";
        default: return "shaders/resize.ps.FILTER=BSPLINE";
    }
}

ResizeConstants ConstantsFor(Extent2D source, Extent2D result) {
    ResizeConstants constants{};
    constants.extentTexels = int2(source.widthTexels, source.heightTexels);
    constants.stepTexels =
        float2(source.widthTexels, source.heightTexels) / float2(result.widthTexels, result.heightTexels);
    return constants;
}

ShrinkDesc Checked(const ShrinkDesc& desc) {
    const float2 size = glm::max(ConstantsFor(desc.source, desc.result).stepTexels, 1.0f);
    const float mass = SATLargestMass(SATPrecision::U64, desc.codes);
    if (!SATBoxIsExact(size, static_cast<int>(desc.order), false, mass))
        throw Error("from {} x {} to {} x {} texels: kernels of order {} fit into 64 bits down to 1 / {}",
                    desc.source.widthTexels, desc.source.heightTexels, desc.result.widthTexels,
                    desc.result.heightTexels, desc.order,
                    SATLargestWidthTexels(SATPrecision::U64, desc.codes, desc.order, false));
    return desc;
}

}  // namespace

Enlarge::Enlarge(Device& device, Extent2D source, Extent2D result, ResizeFilter filter)
    : m_source(source),
      m_pipeline(device, {passes_shaders::Find("shaders/quad.vs"), passes_shaders::Find(ShaderOf(filter))}),
      m_result(device, {result, Format::RGBA32F, "resized"}) {
    if (filter == ResizeFilter::InterpolatingBSpline) m_prefilter.emplace(device, source);
}

const Image& Enlarge::Record(CommandList& commands, const Image& source) {
    const Image& coefficients = m_prefilter ? m_prefilter->Record(commands, source) : source;
    const ResizeConstants constants = ConstantsFor(m_source, m_result.Extent());
    commands.Draw({.name = "resize",
                   .pipeline = m_pipeline,
                   .reads = {{"source", &coefficients}},
                   .writes = {&m_result},
                   .constants = ConstantBytes(constants)});
    return m_result;
}

Shrink::Shrink(Device& device, const ShrinkDesc& desc)
    : m_desc(Checked(desc)),
      m_table(device, {.extent = desc.source, .precision = SATPrecision::U64, .order = desc.order}),
      m_pipeline(device, {passes_shaders::Find("shaders/quad.vs"), passes_shaders::Find("shaders/resize_table.ps")}),
      m_result(device, {desc.result, Format::RGBA32F, "resized"}) {}

const Image& Shrink::Record(CommandList& commands, TexelWords codes) {
    const TexelWords table = m_table.Record(commands, codes);
    ResizeConstants constants = ConstantsFor(m_desc.source, m_desc.result);
    constants.order = static_cast<int>(m_desc.order);
    constants.codeScale = m_desc.codes.scale;
    constants.isSigned = m_desc.codes.isSigned;
    commands.Draw({.name = "resize",
                   .pipeline = m_pipeline,
                   .reads = {{"table", table.low}, {"tableHigh", table.high}},
                   .writes = {&m_result},
                   .constants = ConstantBytes(constants)});
    return m_result;
}

}  // namespace boxcar
