#include "runtime/passes/layered_depth_of_field.h"

#include <algorithm>
#include <cmath>

#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

// Where a surface bends, its layers' coverages add up to a little less than 1: what is hidden there would glimmer
// through.
constexpr float kClosing = 1.05f;
constexpr float kFilling = 1e6f;  // any coverage is enough

glm::vec2 LargestBoxTexels(const LayeredDepthOfFieldDesc& desc) {
    const auto boxes = static_cast<float>(desc.boxes);
    return {std::ceil(desc.largestTexels), std::ceil(desc.largestTexels / boxes) + 1};  // edges are rounded
}

// Diameters of the circles that the layers on one side of the focus stand for, from the sharp one on: each wider than
// the one before by the same factor, as nearly as odd whole numbers are. Those have whole rows round a texel's
// middle.
std::vector<float> Diameters(float largestTexels, int layers) {
    std::vector<float> diameters = {1};
    for (int layer = 1; layer <= layers; layer++) {
        const float wanted = std::pow(largestTexels, static_cast<float>(layer) / static_cast<float>(layers));
        diameters.push_back(std::max(2 * std::round((wanted - 1) / 2) + 1, diameters.back() + 2));
    }
    return diameters;
}

}  // namespace

LayeredDepthOfField::LayeredDepthOfField(Device& device, const LayeredDepthOfFieldDesc& desc)
    : m_desc(desc),
      m_precision(SATExactPrecision(LargestBoxTexels(desc), 1, true, desc.codes)),
      m_take(device, QuadShaders("lens_layer.ps")),
      m_over(device, QuadShaders(fmt::format("lens_over.ps.WORDS={}", WordsOf(m_precision)))),
      m_layer(device, {desc.extent, Format::RGBA32F, "layer"}),
      m_table(device, {.extent = desc.extent, .precision = m_precision, .codes = desc.codes}),
      m_light(device, {desc.extent, Format::RGBA32F, "light"}) {}

const Image& LayeredDepthOfField::Record(CommandList& commands, const Image& nearest, const Image* hidden,
                                         const Lens& lens, float largestDisparity, int layersPerSide) {
    BOXCAR_ASSERT(layersPerSide >= 1);
    const auto upTo = [&](float disparity) {
        const float widestTexels = lens.apertureTexels * std::abs(disparity - lens.focusDisparity);
        return Diameters(std::clamp(widestTexels, 1.0f, m_desc.largestTexels), layersPerSide);
    };
    const std::vector<float> before = upTo(std::max(largestDisparity, lens.focusDisparity)), behind = upTo(0);
    const auto diameterTexels = [&](int layer) {
        return (layer > 0 ? before : behind)[static_cast<size_t>(std::abs(layer))];
    };
    const auto beyond = [](int layers) { return 1e30f * static_cast<float>(layers); };
    const auto knot = [&](int layer) {
        if (layer > layersPerSide) return beyond(layer - layersPerSide);  // the last layers hold all beyond them
        if (layer < -layersPerSide) return beyond(layer + layersPerSide);
        const float square = diameterTexels(layer) * diameterTexels(layer) - 1;
        return layer > 0 ? square : -square;
    };

    commands.Clear(m_light.Front(), {0, 0, 0, 0});
    for (int layer = layersPerSide; layer >= -layersPerSide; layer--) {
        LensLayerConstants take{lens.focusDisparity, lens.apertureTexels, knot(layer - 1), knot(layer),
                                knot(layer + 1),     knot(layer + 2),     knot(layer + 3)};
        if (!hidden) take.secondBeforeKnot = beyond(10), take.thirdBeforeKnot = beyond(11);
        Put(commands, nearest, hidden ? *hidden : nearest, take, diameterTexels(layer), kClosing,
            hidden && layer == -layersPerSide);
    }
    // What something near lets through is like what is seen round it farther away; of what is in focus only where
    // there is nothing else.
    if (!hidden)
        Put(commands, nearest, nearest,
            {lens.focusDisparity, lens.apertureTexels, beyond(-1), knot(-1), -knot(-1) / 63, beyond(10), beyond(11)},
            before.back(), kFilling, true);
    return m_light.Front();
}

void LayeredDepthOfField::Put(CommandList& commands, const Image& nearest, const Image& hidden,
                              const LensLayerConstants& knots, float diameterTexels, float opacity, bool isLast) {
    commands.Draw({.name = "layer",
                   .pipeline = m_take,
                   .reads = {{"nearest", &nearest}, {"hidden", &hidden}},
                   .writes = {&m_layer},
                   .constants = ConstantBytes(knots)});
    const TexelWords table = m_table.Record(commands, m_layer);
    const LensOverConstants constants{
        .diameterTexels = diameterTexels,
        .boxes = std::min(static_cast<int>(diameterTexels), static_cast<int>(m_desc.boxes)),
        .sides = static_cast<int>(m_desc.sides),
        .codeScale = m_desc.codes.scale,
        .opacity = opacity,
        .isLast = isLast};
    commands.Draw({.name = "over",
                   .pipeline = m_over,
                   .reads = TableReads(table, {{"before", &m_light.Front()}}),
                   .writes = {&m_light.Back()},
                   .constants = ConstantBytes(constants)});
    m_light.Swap();
}

}  // namespace boxcar
