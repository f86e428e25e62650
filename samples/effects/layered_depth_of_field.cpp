#include "samples/effects/layered_depth_of_field.h"

#include <algorithm>
#include <cmath>

#include "hlsl/constants/effect_constants.h"
#include "passes_shaders.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

PipelineDesc QuadShaders(const char* pixel) {
    return {.vertex = passes_shaders::Find("shaders/quad.vs"), .pixel = passes_shaders::Find(pixel)};
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
      m_take(device, QuadShaders("shaders/lens_layer.ps")),
      m_over(device, QuadShaders("shaders/lens_over.ps")),
      m_layer(device, {desc.extent, Format::RGBA32F, "layer"}),
      m_table(device, {.extent = desc.extent, .codes = kLensCodes}),
      m_light(device, {desc.extent, Format::RGBA32F, "light"}) {}

const Image& LayeredDepthOfField::Record(CommandList& commands, const Image& nearest, const Image& hidden,
                                         const Lens& lens, float largestDisparity, int layersPerSide) {
    BOXCAR_ASSERT(layersPerSide >= 1);
    const auto upTo = [&](float disparity) {
        const float widestTexels = lens.apertureTexels * std::abs(disparity - lens.focusDisparity);
        return Diameters(std::clamp(widestTexels, 1.0f, kLargestLensTexels), layersPerSide);
    };
    const std::vector<float> before = upTo(std::max(largestDisparity, lens.focusDisparity)), behind = upTo(0);
    const auto diameterTexels = [&](int layer) {
        return (layer > 0 ? before : behind)[static_cast<size_t>(std::abs(layer))];
    };
    const auto knot = [&](int layer) {
        if (std::abs(layer) > layersPerSide)
            return layer > 0 ? 1e30f : -1e30f;  // the last layers hold all beyond them
        const float square = diameterTexels(layer) * diameterTexels(layer) - 1;
        return layer > 0 ? square : -square;
    };
    commands.Clear(m_light.Front(), {0, 0, 0, 0});
    for (int layer = layersPerSide; layer >= -layersPerSide; layer--) {
        const LensLayerConstants take{lens.focusDisparity, lens.apertureTexels, knot(layer - 1), knot(layer),
                                      knot(layer + 1),     knot(layer + 2),     knot(layer + 3)};
        commands.Draw({.name = "layer",
                       .pipeline = m_take,
                       .reads = {{"nearest", &nearest}, {"hidden", &hidden}},
                       .writes = {&m_layer},
                       .constants = ConstantBytes(take)});
        const TexelWords table = m_table.Record(commands, m_layer);
        const LensOverConstants over{
            .diameterTexels = diameterTexels(layer),
            .boxes = std::min(static_cast<int>(diameterTexels(layer)), static_cast<int>(m_desc.boxes)),
            .sides = static_cast<int>(m_desc.sides),
            .codeScale = kLensCodes.scale,
            .isLast = layer == -layersPerSide};
        commands.Draw({.name = "over",
                       .pipeline = m_over,
                       .reads = {{"table", table.low}, {"before", &m_light.Front()}},
                       .writes = {&m_light.Back()},
                       .constants = ConstantBytes(over)});
        m_light.Swap();
    }
    return m_light.Front();
}

}  // namespace boxcar
