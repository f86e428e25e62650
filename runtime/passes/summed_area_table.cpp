#include "runtime/passes/summed_area_table.h"

#include <algorithm>

#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

uint32_t CheckedTaps(uint32_t taps) {
    if (taps == 2 || taps == 4 || taps == 8 || taps == 16) return taps;
    throw Error("{} taps: a pass adds 2, 4, 8 or 16 texels", taps);
}

PipelineDesc PassShaders(uint32_t taps, TapAddressing addressing) {
    const auto permutation = [&](const char* name) { return fmt::format("shaders/{}.TAPS={}", name, taps); };
    if (addressing == TapAddressing::Integer)
        return {passes_shaders::Find("shaders/quad.vs"), passes_shaders::Find(permutation("sat_pass_load.ps"))};
    return {passes_shaders::Find(permutation("sat_pass.vs")), passes_shaders::Find(permutation("sat_pass.ps"))};
}

}  // namespace

uint32_t SummedAreaTablePassCount(uint32_t sizeTexels, uint32_t taps) {
    uint32_t passes = 0;
    for (uint64_t reach = 1; reach < sizeTexels; reach *= taps)
        passes++;
    return passes;
}

SummedAreaTable::SummedAreaTable(Device& device, const SummedAreaTableDesc& desc)
    : m_desc(desc), m_targets(device, {desc.extent, Format::RGBA32F, "summed-area table"}) {
    CheckedTaps(desc.taps);
    AddAxis(desc.extent.widthTexels, {1, 0});
    AddAxis(desc.extent.heightTexels, {0, 1});
    for (const Step& step : m_steps)
        if (!m_passes.contains(step.taps))
            m_passes.emplace(step.taps, Pipeline(device, PassShaders(step.taps, desc.addressing)));
    if (desc.bias != glm::vec4(0))
        m_takeOffBias.emplace(device, PipelineDesc{passes_shaders::Find("shaders/quad.vs"),
                                                   passes_shaders::Find("shaders/sat_bias.ps")});
}

// Pass i leaves out the first taps^(i-1) texels of its axis: the pass before the last one has put their final sums
// into this target already. (taps^i, as the paper has it, would leave stale texels in one of the two targets.) The
// first two passes of all write everything: until then a target holds nothing.
void SummedAreaTable::AddAxis(uint32_t sizeTexels, glm::ivec2 axis) {
    const uint32_t passes = SummedAreaTablePassCount(sizeTexels, m_desc.taps);
    uint32_t stride = 1;
    for (uint32_t i = 0; i < passes; i++, stride *= m_desc.taps) {
        const uint32_t finished = i == 0 || m_steps.size() < 2 ? 0 : stride / m_desc.taps;
        Rect area{0, 0, m_desc.extent.widthTexels, m_desc.extent.heightTexels};
        (axis.x ? area.xTexels : area.yTexels) = finished;
        (axis.x ? area.widthTexels : area.heightTexels) -= finished;
        uint32_t taps = m_desc.taps;
        while (taps > 2 && stride * (taps / 2) >= sizeTexels)
            taps /= 2;
        m_steps.push_back(
            {fmt::format("table {}{}", axis.x ? 'x' : 'y', i), taps, static_cast<int>(stride) * axis, area});
    }
}

const Image& SummedAreaTable::Record(CommandList& commands, const Image& source) {
    return RecordFirst(commands, source, Passes());
}

const Image& SummedAreaTable::RecordFirst(CommandList& commands, const Image& source, uint32_t passes) {
    BOXCAR_ASSERT(source.Extent() == m_desc.extent);
    BOXCAR_ASSERT(passes <= Passes());
    const Image* from = &source;
    if (m_takeOffBias) {
        const SATBiasConstants constants{m_desc.bias};
        commands.Draw({.name = "take off bias",
                       .pipeline = *m_takeOffBias,
                       .reads = {{"source", from}},
                       .writes = {&m_targets.Back()},
                       .constants = ConstantBytes(constants)});
        m_targets.Swap();
        from = &m_targets.Front();
    }
    const float2 texelUv = 1.0f / float2(m_desc.extent.widthTexels, m_desc.extent.heightTexels);
    for (const Step& step : std::span(m_steps).first(passes)) {
        const SATPassConstants constants{float2(step.strideTexels) * texelUv, step.strideTexels};
        commands.Draw({.name = step.name,
                       .pipeline = m_passes.at(step.taps),
                       .reads = {{"source", from}},
                       .writes = {&m_targets.Back()},
                       .constants = ConstantBytes(constants),
                       .area = step.area});
        m_targets.Swap();
        from = &m_targets.Front();
    }
    return *from;
}

}  // namespace boxcar
