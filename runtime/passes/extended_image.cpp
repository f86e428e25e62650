#include "runtime/passes/extended_image.h"

#include <fmt/format.h>

#include "hlsl/constants/sat_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

Extent2D Extended(const ExtendedImageDesc& desc) {
    return {desc.extent.widthTexels + 2 * desc.padding.widthTexels,
            desc.extent.heightTexels + 2 * desc.padding.heightTexels};
}

}  // namespace

ExtendedImage::ExtendedImage(Device& device, const ExtendedImageDesc& desc)
    : m_desc(desc),
      m_pipeline(device, QuadShaders(fmt::format("sat_extend.ps.WORDS={}", WordsOf(desc.precision)),
                                     std::vector(WordsOf(desc.precision), WordFormat(desc.precision)))),
      m_low(device, {Extended(desc), WordFormat(desc.precision), "extended"}) {
    if (desc.precision == SATPrecision::U64)
        m_high.emplace(device, ImageDesc{Extended(desc), Format::RGBA32UI, "extended, upper words"});
}

TexelWords ExtendedImage::Record(CommandList& commands, TexelWords source) {
    BOXCAR_ASSERT(source.low->Extent() == m_desc.extent);
    const SATExtendConstants constants{int2(m_desc.extent.widthTexels, m_desc.extent.heightTexels),
                                       int2(m_desc.padding.widthTexels, m_desc.padding.heightTexels),
                                       m_desc.isMirrored};
    Pass pass{.name = "extend",
              .pipeline = m_pipeline,
              .reads = {{"source", source.low}},
              .writes = {&m_low},
              .constants = ConstantBytes(constants)};
    if (m_high) {
        pass.reads.push_back({"sourceHigh", source.high});
        pass.writes.push_back(&*m_high);
    }
    commands.Draw(pass);
    return m_high ? TexelWords(m_low, *m_high) : TexelWords(m_low);
}

}  // namespace boxcar
