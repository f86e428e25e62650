#include "runtime/passes/mean.h"

#include <fmt/format.h>

#include "hlsl/constants/sat_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/base/error.h"

namespace boxcar {

Mean::Mean(Device& device, Extent2D extent) : m_extent(extent), m_pipeline(device, QuadShaders("mean.ps")) {
    while (extent.widthTexels > 1 || extent.heightTexels > 1) {
        extent = {(extent.widthTexels + 1) / 2, (extent.heightTexels + 1) / 2};
        const std::string name = fmt::format("mean {}", m_levels.size());
        m_levels.emplace_back(device, ImageDesc{extent, Format::RGBA32F, name});
    }
}

const Image& Mean::Record(CommandList& commands, const Image& source) {
    BOXCAR_ASSERT(source.Extent() == m_extent);
    const Image* from = &source;
    for (const Image& level : m_levels) {
        const bool isLast = level.Extent() == Extent2D{1, 1};
        const MeanConstants constants{int2(from->Extent().widthTexels, from->Extent().heightTexels),
                                      isLast ? static_cast<float>(m_extent.Texels()) : 1.0f};
        commands.Draw({.name = level.Desc().name,
                       .pipeline = m_pipeline,
                       .reads = {{"source", from}},
                       .writes = {&level},
                       .constants = ConstantBytes(constants)});
        from = &level;
    }
    return *from;
}

}  // namespace boxcar
