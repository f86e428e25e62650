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
                                     WordFormats(desc.precision))),
      m_extended(device, desc.precision, Extended(desc), "extended") {}

TexelWords ExtendedImage::Record(CommandList& commands, TexelWords source) {
    BOXCAR_ASSERT(source.low->Extent() == m_desc.extent);
    const SATExtendConstants constants{int2(m_desc.extent.widthTexels, m_desc.extent.heightTexels),
                                       int2(m_desc.padding.widthTexels, m_desc.padding.heightTexels),
                                       m_desc.isMirrored};
    commands.Draw({.name = "extend",
                   .pipeline = m_pipeline,
                   .reads = source.Reads("source", "sourceHigh"),
                   .writes = m_extended.Writes(),
                   .constants = ConstantBytes(constants)});
    return m_extended;
}

}  // namespace boxcar
