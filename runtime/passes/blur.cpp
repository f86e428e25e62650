#include "runtime/passes/blur.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include "runtime/transfer.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

bool NeedsExtension(const BlurDesc& desc) {
    return desc.order > 1 && (desc.edge == SATEdge::Repeat || desc.edge == SATEdge::Mirror);
}

Extent2D Padding(const BlurDesc& desc) {
    return NeedsExtension(desc) ? BlurReach(desc.order, desc.largestTexels) : Extent2D{0, 0};
}

Extent2D TableExtent(const BlurDesc& desc) {
    return {desc.extent.widthTexels + 2 * Padding(desc).widthTexels,
            desc.extent.heightTexels + 2 * Padding(desc).heightTexels};
}

}  // namespace

Extent2D BlurReach(uint32_t order, glm::vec2 sizeTexels) {
    const glm::vec2 reach = 0.5f * static_cast<float>(order) * glm::max(sizeTexels, glm::vec2(1));
    return {static_cast<uint32_t>(std::ceil(reach.x)) + 1, static_cast<uint32_t>(std::ceil(reach.y)) + 1};
}

Blur::Blur(Device& device, const BlurDesc& desc)
    : m_desc(desc),
      m_table(device, {.extent = TableExtent(desc),
                       .precision = desc.precision,
                       .order = desc.order,
                       .taps = desc.taps,
                       .origin = desc.origin}),
      m_filter(device, {.extent = desc.extent,
                        .precision = desc.precision,
                        .order = desc.order,
                        .boxes = desc.boxes,
                        .sides = desc.sides,
                        .edge = NeedsExtension(desc) ? SATEdge::Zero : desc.edge,
                        .origin = desc.origin,
                        .padding = Padding(desc),
                        .codes = desc.codes}) {
    if (desc.bias != BlurBias::None && desc.precision != SATPrecision::FP32)
        throw Error("a bias for integers: it is for floats, integers do not round");
    if (desc.bias == BlurBias::Mean) m_mean.emplace(device, desc.extent);
    if (desc.bias == BlurBias::Half) {
        m_half.emplace(device, ImageDesc{{1, 1}, Format::RGBA32F, "half"});
        const glm::vec4 half(0.5f);
        WriteTexels(device, *m_half, std::as_bytes(std::span(&half, 1)));
    }
    if (NeedsExtension(desc))
        m_extended.emplace(
            device, ExtendedImageDesc{desc.extent, Padding(desc), desc.precision, desc.edge == SATEdge::Mirror});
}

const Image& Blur::Record(CommandList& commands, TexelWords source, const SATWidths& widths) {
    if (m_extended)
        BOXCAR_ASSERT(glm::all(glm::lessThanEqual(widths.maxTexels, glm::max(m_desc.largestTexels, 1.0f))));
    const Image* bias = m_mean ? &m_mean->Record(commands, *source.low) : m_half ? &*m_half : nullptr;
    if (m_extended) source = m_extended->Record(commands, source);
    return m_filter.Record(commands, m_table.Record(commands, source, bias), widths, bias);
}

}  // namespace boxcar
