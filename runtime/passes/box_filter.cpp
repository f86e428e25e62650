#include "runtime/passes/box_filter.h"

#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "tools/layout/error.h"

namespace boxcar {

BoxFilter::BoxFilter(Device& device, const BoxFilterDesc& desc)
    : m_desc(desc),
      m_pipeline(device, {passes_shaders::Find("shaders/quad.vs"),
                          passes_shaders::Find(desc.edge == BoxEdge::Zero ? "shaders/sat_filter.ps.EDGE_ZERO=1"
                                                                          : "shaders/sat_filter.ps.EDGE_ZERO=0")}),
      m_result(device, {desc.extent, Format::RGBA32F, "filtered"}) {}

const Image& BoxFilter::Record(CommandList& commands, const Image& table, glm::vec2 sizeTexels) {
    BOXCAR_ASSERT(table.Extent() == m_desc.extent);
    const SATFilterConstants constants{int2(m_desc.extent.widthTexels, m_desc.extent.heightTexels), sizeTexels,
                                       m_desc.bias};
    commands.Draw({.name = "filter",
                   .pipeline = m_pipeline,
                   .reads = {{"table", &table}},
                   .writes = {&m_result},
                   .constants = ConstantBytes(constants)});
    return m_result;
}

}  // namespace boxcar
