#include "runtime/passes/exact_table.h"

#include "hlsl/constants/sat_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

ExactTableDesc Checked(const ExactTableDesc& desc) {
    if (desc.precision == SATPrecision::FP32) throw Error("an exact table of floats: expected u32 or u64");
    if (desc.codes.isSigned) throw Error("an exact table of light with negative codes: light is 0 or more");
    return desc;
}

}  // namespace

ExactTable::ExactTable(Device& device, const ExactTableDesc& desc)
    : m_desc(Checked(desc)),
      m_encode(device, QuadShaders(fmt::format("sat_encode.ps.WORDS={}", WordsOf(desc.precision)),
                                   std::vector(WordsOf(desc.precision), Format::RGBA32UI))),
      m_low(device, {desc.extent, Format::RGBA32UI, "codes"}),
      m_table(device, {.extent = desc.extent, .precision = desc.precision, .order = desc.order, .taps = desc.taps}) {
    if (desc.precision == SATPrecision::U64)
        m_high.emplace(device, ImageDesc{desc.extent, Format::RGBA32UI, "codes, upper words"});
}

TexelWords ExactTable::Record(CommandList& commands, const Image& source) {
    BOXCAR_ASSERT(source.Extent() == m_desc.extent);
    const SATEncodeConstants constants{m_desc.codes.scale, static_cast<float>(m_desc.codes.largest)};
    Pass pass{.name = "encode",
              .pipeline = m_encode,
              .reads = {{"source", &source}},
              .writes = {&m_low},
              .constants = ConstantBytes(constants)};
    if (m_high) pass.writes.push_back(&*m_high);
    commands.Draw(pass);
    return m_table.Record(commands, m_high ? TexelWords(m_low, *m_high) : TexelWords(m_low));
}

}  // namespace boxcar
