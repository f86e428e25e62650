#include "runtime/passes/sat_filter.h"

#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "hlsl/boxcar/sat_range.h"
#include "hlsl/constants/sat_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "runtime/transfer.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint32_t kMaxWidthTexels = 32768;

SATFilterDesc Checked(const SATFilterDesc& desc) {
    const bool isFloat = desc.precision == SATPrecision::FP32;
    const bool isRepeated = desc.edge == SATEdge::Repeat || desc.edge == SATEdge::Mirror;
    if (desc.order < 1 || desc.order > 3) throw Error("order {}: kernels are of order 1, 2 or 3", desc.order);
    if (isFloat && desc.order > 1)
        throw Error("order {} in floats: tents and parabolic kernels need integers", desc.order);
    if (desc.boxes < 1 || desc.boxes > 1024) throw Error("{} boxes: a disc is made of 1 to 1024", desc.boxes);
    if (desc.sides != 0 && (desc.sides < 3 || desc.sides > 16))
        throw Error("{} sides: a polygon has 3 to 16; 0 is a disc", desc.sides);
    if (desc.boxes > 1 && desc.order > 1)
        throw Error("a disc of {} boxes is of order 1, not {}", desc.boxes, desc.order);
    if (isRepeated && desc.order > 1)
        throw Error("order {} over a repeated image: extend the image first (ExtendedImage)", desc.order);
    if (desc.origin != SATOrigin::Corner && (isRepeated || !isFloat))
        throw Error("integers and repeated images need sums that start at the upper left corner");
    return desc;
}

const char* EdgeName(SATEdge edge) {
    constexpr const char* kNames[] = {"SAT_EDGE_CLIP", "SAT_EDGE_ZERO", "SAT_EDGE_REPEAT", "SAT_EDGE_MIRROR"};
    return kNames[static_cast<size_t>(edge)];
}

const char* KernelName(const SATFilterDesc& desc) {
    constexpr const char* kNames[] = {"box", "tent", "parabolic kernel"};
    return desc.boxes > 1 ? "disc" : kNames[desc.order - 1];
}

Image OneTexelOfZero(Device& device) {
    Image image(device, {{1, 1}, Format::RGBA32F, "zero"});
    const glm::vec4 zero(0);
    WriteTexels(device, image, std::as_bytes(std::span(&zero, 1)));
    return image;
}

}  // namespace

float SATLargestMass(SATPrecision precision, const SATCodes& codes) {
    if (precision == SATPrecision::FP32) return std::numeric_limits<float>::infinity();
    const double range = std::ldexp(1.0, 32 * static_cast<int>(WordsOf(precision)) - (codes.isSigned ? 1 : 0));
    const double mass = std::floor((range - 1) / std::max(codes.largest, 1.0));
    const float rounded = static_cast<float>(mass);
    return rounded > mass ? std::nextafter(rounded, 0.0f) : rounded;
}

uint32_t SATLargestWidthTexels(SATPrecision precision, const SATCodes& codes, uint32_t order, bool isWhole) {
    const float mass = SATLargestMass(precision, codes);
    const uint32_t step = order == 3 && isWhole ? 2 : 1;
    uint32_t fits = 0, fails = kMaxWidthTexels / step + 1;
    const auto width = [&](uint32_t index) { return step * (index - 1) + 1; };
    while (fails - fits > 1) {
        const uint32_t middle = (fits + fails) / 2;
        const float2 size(static_cast<float>(width(middle)));
        (SATBoxIsExact(size, static_cast<int>(order), isWhole, mass) ? fits : fails) = middle;
    }
    return fits == 0 ? 0 : width(fits);
}

bool SATIsWhole(glm::vec2 sizeTexels, uint32_t order) {
    const auto axis = [&](float width) {
        return width == std::floor(width) && order * (static_cast<uint32_t>(width) - 1) % 2 == 0;
    };
    return axis(std::max(sizeTexels.x, 1.0f)) && axis(std::max(sizeTexels.y, 1.0f));
}

SATPrecision SATExactPrecision(glm::vec2 sizeTexels, uint32_t order, bool isWhole, const SATCodes& codes) {
    const float mass = SATLargestMass(SATPrecision::U32, codes);
    const bool fits = SATBoxIsExact(sizeTexels, static_cast<int>(order), isWhole, mass);
    return fits ? SATPrecision::U32 : SATPrecision::U64;
}

SATGaussian SATGaussianWithin(float relativeError) {
    // Minima of the distance over the width (SATGaussian.ErrorsAndWidthsAreThoseOfTheBestKernels).
    constexpr SATGaussian kKernels[] = {{1, 3.274f, 0.530f}, {2, 2.316f, 0.098f}, {3, 1.923f, 0.042f}};
    for (const SATGaussian& kernel : kKernels)
        if (kernel.relativeError <= relativeError) return kernel;
    throw Error("a Gaussian within {:g} %: the nearest kernel, the parabolic one, is within {:g} %",
                100 * relativeError, 100 * kKernels[2].relativeError);
}

SATFilter::SATFilter(Device& device, const SATFilterDesc& desc)
    : m_device(device),
      m_desc(Checked(desc)),
      m_zero(OneTexelOfZero(device)),
      m_result(device, {desc.extent, Format::RGBA32F, "filtered"}) {}

const Pipeline& SATFilter::PipelineFor(bool whole) {
    const auto found = m_pipelines.find(whole);
    if (found != m_pipelines.end()) return found->second;
    const std::string name = m_desc.precision == SATPrecision::FP32
                                 ? fmt::format("sat_filter.ps.EDGE={}", EdgeName(m_desc.edge))
                                 : fmt::format("sat_filter_exact.ps.ORDER={}.WHOLE={:d}.WORDS={}.EDGE={}",
                                               m_desc.order, whole, WordsOf(m_desc.precision), EdgeName(m_desc.edge));
    return m_pipelines.emplace(whole, Pipeline(m_device, QuadShaders(name))).first->second;
}

const Image& SATFilter::Record(CommandList& commands, TexelWords table, const SATWidths& widths, const Image* bias) {
    const Extent2D tableExtent{m_desc.extent.widthTexels + 2 * m_desc.padding.widthTexels,
                               m_desc.extent.heightTexels + 2 * m_desc.padding.heightTexels};
    BOXCAR_ASSERT(table.low->Extent() == tableExtent);
    BOXCAR_ASSERT(!widths.map || widths.map->Extent() == m_desc.extent);
    BOXCAR_ASSERT(!bias || m_desc.precision == SATPrecision::FP32);

    const bool isFloat = m_desc.precision == SATPrecision::FP32;
    const bool isRepeated = m_desc.edge == SATEdge::Repeat || m_desc.edge == SATEdge::Mirror;
    const glm::vec2 size = glm::max(widths.maxTexels, glm::vec2(1));
    const float largestMass = SATLargestMass(m_desc.precision, m_desc.codes);
    const bool whole = !isFloat && !widths.map && m_desc.boxes == 1 && m_desc.sides == 0 && !isRepeated &&
                       SATIsWhole(size, m_desc.order);
    if (!isFloat && !widths.map && !SATBoxIsExact(size, static_cast<int>(m_desc.order), whole, largestMass)) {
        const uint32_t side = SATLargestWidthTexels(m_desc.precision, m_desc.codes, m_desc.order, whole);
        throw Error("a {} of {} x {} texels over codes up to {:.0f} may not fit into {} bits: {} holds {} x {}",
                    KernelName(m_desc), size.x, size.y, m_desc.codes.largest, 32 * WordsOf(m_desc.precision),
                    SATPrecisionName(m_desc.precision), side, side);
    }

    const auto isWhole = [&](float width) { return !widths.map && SATIsWhole(glm::vec2(width), m_desc.order); };
    const Image& map = widths.map ? *widths.map : m_zero;
    const SATFilterConstants constants{int2(tableExtent.widthTexels, tableExtent.heightTexels),
                                       OriginTexels(m_desc.origin, tableExtent),
                                       int2(m_desc.padding.widthTexels, m_desc.padding.heightTexels),
                                       int2(map.Extent().widthTexels, map.Extent().heightTexels),
                                       widths.minTexels,
                                       widths.maxTexels,
                                       static_cast<int>(m_desc.boxes),
                                       static_cast<int>(m_desc.sides),
                                       m_desc.codes.isSigned,
                                       m_desc.codes.scale,
                                       largestMass,
                                       isWhole(size.x),
                                       isWhole(size.y)};
    Pass pass{.name = "filter",
              .pipeline = PipelineFor(whole),
              .reads = TableReads(table, {{"widthMap", &map}}),
              .writes = {&m_result},
              .constants = ConstantBytes(constants)};
    if (isFloat) pass.reads.push_back({"bias", bias ? bias : &m_zero});
    commands.Draw(pass);
    return m_result;
}

}  // namespace boxcar
