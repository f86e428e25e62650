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
                                   WordFormats(desc.precision))),
      m_codes(device, desc.precision, desc.extent, "codes"),
      m_table(device, {.extent = desc.extent, .precision = desc.precision, .order = desc.order, .taps = desc.taps}) {}

TexelWords ExactTable::Record(CommandList& commands, const Image& source) {
    BOXCAR_ASSERT(source.Extent() == m_desc.extent);
    const SATEncodeConstants constants{m_desc.codes.scale, static_cast<float>(m_desc.codes.largest)};
    commands.Draw({.name = "encode",
                   .pipeline = m_encode,
                   .reads = {{"source", &source}},
                   .writes = m_codes.Writes(),
                   .constants = ConstantBytes(constants)});
    return m_table.Record(commands, m_codes);
}

}  // namespace boxcar
