#include "runtime/passes/summed_area_table.h"

#include <algorithm>
#include <cmath>

#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

SummedAreaTableDesc Checked(SummedAreaTableDesc desc) {
    if (desc.taps != 2 && desc.taps != 4 && desc.taps != 8 && desc.taps != 16)
        throw Error("{} taps: a pass adds 2, 4, 8 or 16 texels", desc.taps);
    if (desc.order < 1 || desc.order > 3) throw Error("order {}: tables are of order 1, 2 or 3", desc.order);
    const bool isFloat = desc.precision == SATPrecision::FP32;
    if (isFloat && desc.order > 1)
        throw Error("order {} in floats: they have too few digits for it; U32 and U64 hold it exactly", desc.order);
    if (!isFloat || desc.origin != SATOrigin::Corner) desc.addressing = TapAddressing::Integer;
    return desc;
}

}  // namespace

glm::ivec2 OriginTexels(SATOrigin origin, Extent2D extent) {
    switch (origin) {
        case SATOrigin::Corner: return {0, 0};
        case SATOrigin::Center: return {extent.widthTexels / 2, extent.heightTexels / 2};
        case SATOrigin::LowerLeft: return {0, extent.heightTexels};
    }
    return {};
}

uint32_t SummedAreaTablePassCount(uint32_t sizeTexels, uint32_t taps) {
    uint32_t passes = 0;
    for (uint64_t reach = 1; reach < sizeTexels; reach *= taps)
        passes++;
    return passes;
}

uint32_t SummedAreaTablePassTaps(uint32_t taps, uint32_t strideTexels, uint32_t sizeTexels) {
    while (taps > 2 && strideTexels * (taps / 2) >= sizeTexels)
        taps /= 2;
    return taps;
}

double SummedAreaTableBits(Extent2D extent, uint32_t sampleBits, uint32_t order) {
    return order * (std::log2(extent.widthTexels) + std::log2(extent.heightTexels)) + sampleBits;
}

uint64_t SummedAreaTableBytes(Extent2D extent, SATPrecision precision) {
    return 2 * WordsOf(precision) * extent.Texels() * BytesPerTexel(WordFormat(precision));
}

SummedAreaTable::SummedAreaTable(Device& device, const SummedAreaTableDesc& desc)
    : m_desc(Checked(desc)),
      m_targets{WordImages(device, desc.precision, desc.extent, "summed-area table A"),
                WordImages(device, desc.precision, desc.extent, "summed-area table B")} {
    for (int axis = 0; axis < 2; axis++)
        for (uint32_t time = 0; time < desc.order; time++)
            AddAxis(axis, time);
    for (const Step& step : m_steps)
        if (!m_passes.contains(step.taps)) m_passes.emplace(step.taps, Pipeline(device, PassShaders(step.taps)));
    if (desc.precision == SATPrecision::FP32) m_takeOffBias.emplace(device, QuadShaders("sat_bias.ps"));
}

PipelineDesc SummedAreaTable::PassShaders(uint32_t taps) const {
    const auto find = [](const std::string& name) { return passes_shaders::Find("shaders/" + name); };
    if (m_desc.precision != SATPrecision::FP32) {
        const uint32_t words = WordsOf(m_desc.precision);
        return {find("quad.vs"), find(fmt::format("sat_pass_exact.ps.TAPS={}.WORDS={}", taps, words)),
                WordFormats(m_desc.precision)};
    }
    if (m_desc.addressing == TapAddressing::Integer)
        return {find("quad.vs"), find(fmt::format("sat_pass_load.ps.TAPS={}", taps))};
    return {find(fmt::format("sat_pass.vs.TAPS={}", taps)), find(fmt::format("sat_pass.ps.TAPS={}", taps))};
}

// Pass i leaves out the first taps^(i-1) texels from the origin on: the pass before the last one has put their final
// sums into this target already. (taps^i, as the paper has it, would leave stale texels in one of the two targets.)
// The first two passes of all write everything: until then a target holds nothing. So do those of an origin inside
// the image: what they could leave out lies in the middle.
void SummedAreaTable::AddAxis(int axis, uint32_t time) {
    constexpr const char* kTimes[] = {"", "2nd ", "3rd "};
    const uint32_t size = axis == 0 ? m_desc.extent.widthTexels : m_desc.extent.heightTexels;
    const uint32_t origin = static_cast<uint32_t>(OriginTexels(m_desc.origin, m_desc.extent)[axis]);
    const uint32_t length = std::max(origin, size - origin);
    const uint32_t passes = SummedAreaTablePassCount(length, m_desc.taps);
    uint32_t stride = 1;
    for (uint32_t i = 0; i < passes; i++, stride *= m_desc.taps) {
        const bool writesAll = i == 0 || m_steps.size() < 2 || length < size;
        const uint32_t finished = writesAll ? 0 : stride / m_desc.taps;
        Rect area{0, 0, m_desc.extent.widthTexels, m_desc.extent.heightTexels};
        if (origin == 0) (axis == 0 ? area.xTexels : area.yTexels) = finished;
        (axis == 0 ? area.widthTexels : area.heightTexels) -= finished;
        const uint32_t taps = SummedAreaTablePassTaps(m_desc.taps, stride, length);
        glm::ivec2 strideTexels(0);
        strideTexels[axis] = static_cast<int>(stride);
        m_steps.push_back(
            {fmt::format("{}table {}{}", kTimes[time], axis == 0 ? 'x' : 'y', i), taps, strideTexels, area});
    }
}

// What was drawn last is read next.
TexelWords SummedAreaTable::Swap() {
    m_front = 1 - m_front;
    return m_targets[m_front];
}

TexelWords SummedAreaTable::Record(CommandList& commands, TexelWords source, const Image* bias) {
    return RecordFirst(commands, source, Passes(), bias);
}

TexelWords SummedAreaTable::RecordFirst(CommandList& commands, TexelWords source, uint32_t passes,
                                        const Image* bias) {
    BOXCAR_ASSERT(source.low->Extent() == m_desc.extent);
    BOXCAR_ASSERT((WordsOf(m_desc.precision) == 2) == (source.high != nullptr));
    BOXCAR_ASSERT(!bias || m_takeOffBias);
    BOXCAR_ASSERT(passes <= Passes());
    TexelWords from = source;
    if (bias) {
        commands.Draw({.name = "take off bias",
                       .pipeline = *m_takeOffBias,
                       .reads = {{"source", from.low}, {"bias", bias}},
                       .writes = Back().Writes()});
        from = Swap();
    }
    const float2 texelUv = 1.0f / float2(m_desc.extent.widthTexels, m_desc.extent.heightTexels);
    for (const Step& step : std::span(m_steps).first(passes)) {
        const SATPassConstants constants{float2(step.strideTexels) * texelUv, step.strideTexels,
                                         OriginTexels(m_desc.origin, m_desc.extent)};
        commands.Draw({.name = step.name,
                       .pipeline = m_passes.at(step.taps),
                       .reads = from.Reads("source", "sourceHigh"),
                       .writes = Back().Writes(),
                       .constants = ConstantBytes(constants),
                       .area = step.area});
        from = Swap();
    }
    return from;
}

}  // namespace boxcar
