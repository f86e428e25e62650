#include "samples/effects/resize.h"

#include <algorithm>
#include <glm/common.hpp>

#include "hlsl/boxcar/sat_range.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

const char* ShaderOf(ResizeFilter filter) {
    switch (filter) {
        case ResizeFilter::Nearest: return "resize.ps.FILTER=NEAREST";
        case ResizeFilter::Linear: return "resize.ps.FILTER=LINEAR";
        case ResizeFilter::CatmullRom: return "resize.ps.FILTER=CATMULL_ROM";
        default: return "resize.ps.FILTER=BSPLINE";
    }
}

uint32_t OrderOf(ResizeFilter filter) {
    return filter == ResizeFilter::BSpline ? 3 : 2;
}

ResizeConstants ConstantsFor(const ResizeDesc& desc, const SATCodes& codes = {}) {
    return {.extentTexels = int2(desc.source.widthTexels, desc.source.heightTexels),
            .stepTexels = desc.stepTexels,
            .order = static_cast<int>(OrderOf(desc.filter)),
            .codeScale = codes.scale,
            .isSigned = codes.isSigned};
}

void RequireFits(const ResizeDesc& desc, const SATCodes& codes) {
    const uint32_t order = OrderOf(desc.filter);
    const float mass = SATLargestMass(SATPrecision::U64, codes);
    if (!SATBoxIsExact(glm::max(desc.stepTexels, 1.0f), static_cast<int>(order), false, mass))
        throw Error("from {} x {} to {} x {} texels: sums of order {} fit into 64 bits down to 1 / {}",
                    desc.source.widthTexels, desc.source.heightTexels, desc.result.widthTexels,
                    desc.result.heightTexels, order, SATLargestWidthTexels(SATPrecision::U64, codes, order, false));
}

}  // namespace

bool IsShrunk(const ResizeDesc& desc) {
    return desc.filter != ResizeFilter::Nearest && std::max(desc.stepTexels.x, desc.stepTexels.y) > 1;
}

Enlarge::Enlarge(Device& device, const ResizeDesc& desc)
    : m_constants(ConstantsFor(desc)),
      m_pipeline(device, QuadShaders(ShaderOf(desc.filter))),
      m_result(device, {desc.result, Format::RGBA32F, "resized"}) {
    BOXCAR_ASSERT(!IsShrunk(desc));
    if (desc.filter == ResizeFilter::InterpolatingBSpline) m_prefilter.emplace(device, desc.source);
}

const Image& Enlarge::Record(CommandList& commands, const Image& source) {
    const Image& coefficients = m_prefilter ? m_prefilter->Record(commands, source) : source;
    commands.Draw({.name = "resize",
                   .pipeline = m_pipeline,
                   .reads = {{"source", &coefficients}},
                   .writes = {&m_result},
                   .constants = ConstantBytes(m_constants)});
    return m_result;
}

Shrink::Shrink(Device& device, const ResizeDesc& desc, const SATCodes& codes)
    : m_constants(ConstantsFor(desc, codes)),
      m_table(device, {.extent = desc.source, .precision = SATPrecision::U64, .order = OrderOf(desc.filter)}),
      m_pipeline(device, QuadShaders("resize_table.ps")),
      m_result(device, {desc.result, Format::RGBA32F, "resized"}) {
    BOXCAR_ASSERT(IsShrunk(desc));
    RequireFits(desc, codes);
}

const Image& Shrink::Record(CommandList& commands, TexelWords codes) {
    const TexelWords table = m_table.Record(commands, codes);
    commands.Draw({.name = "resize",
                   .pipeline = m_pipeline,
                   .reads = TableReads(table),
                   .writes = {&m_result},
                   .constants = ConstantBytes(m_constants)});
    return m_result;
}

}  // namespace boxcar
