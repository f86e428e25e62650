#include "runtime/passes/dual_paraboloid.h"

#include <algorithm>
#include <cmath>

#include "hlsl/boxcar/sat_range.h"
#include "hlsl/constants/dp_constants.h"
#include "passes_shaders.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

constexpr double kLargestWeight = 4096;
constexpr const char* kFaceNames[] = {"front", "back"};

PipelineDesc Quad(const std::string& pixel, size_t targets = 1, Format format = Format::RGBA32F) {
    return {.vertex = passes_shaders::Find("shaders/quad.vs"),
            .pixel = passes_shaders::Find("shaders/" + pixel),
            .targets = std::vector(targets, format)};
}

Extent2D Square(uint32_t side) {
    return {side, side};
}

// As many codes as the sum under the largest kernel leaves, and at the most 40 bits: half floats need no more.
float CodeScaleOf(const DualParaboloidTablesDesc& desc) {
    BOXCAR_ASSERT(desc.largestTexels >= 1 && desc.largestTexels <= desc.sideTexels);
    const double mass = std::pow(static_cast<double>(desc.largestTexels), 2.0 * desc.order);
    const double largestCode = std::min(std::ldexp(1.0, 40), std::ldexp(1.0, 63) / mass);
    if (largestCode < kLargestWeight)
        throw Error("kernels of order {} of boxes of {} texels: their sums do not fit into 64 bits", desc.order,
                    desc.largestTexels);
    return static_cast<float>(largestCode / (kLargestWeight * desc.largestLight));
}

}  // namespace

DualParaboloid::DualParaboloid(Device& device, uint32_t sideTexels, DPMapping mapping)
    : m_pipeline(device, Quad(fmt::format("dp_from_cube.ps.LOOKUP={:d}", mapping == DPMapping::Lookup))) {
    for (const std::string name : kFaceNames)
        m_faces.emplace_back(device, ImageDesc{Square(sideTexels), Format::RGBA32F, name + " face"});
    if (mapping == DPMapping::Arithmetic) return;
    m_drawDirections.emplace(device, Quad("dp_directions.ps"));
    for (const std::string name : kFaceNames)
        m_directions.emplace_back(device, ImageDesc{Square(sideTexels), Format::RGBA32F, name + " directions"});
}

DualParaboloidFaces DualParaboloid::Record(CommandList& commands, const Image& cube) {
    BOXCAR_ASSERT(cube.Desc().layers == 6);
    for (size_t face = 0; face < 2; face++) {
        const DPFaceConstants constants{static_cast<int>(face), static_cast<int>(m_faces[0].Extent().widthTexels), 0,
                                        0};
        Pass pass{
            .name = kFaceNames[face], .pipeline = m_pipeline, .reads = {{"cube", &cube}}, .writes = {&m_faces[face]}};
        if (m_drawDirections) {
            if (!m_hasDirections)
                commands.Draw({.name = "directions",
                               .pipeline = *m_drawDirections,
                               .writes = {&m_directions[face]},
                               .constants = ConstantBytes(constants)});
            pass.reads.push_back({"directions", &m_directions[face]});
        } else {
            pass.constants = ConstantBytes(constants);
        }
        commands.Draw(pass);
    }
    m_hasDirections = true;
    return {&m_faces[0], &m_faces[1]};
}

DualParaboloidTables::Face::Face(Device& device, const DualParaboloidTablesDesc& desc, const std::string& name)
    : low(device, {Square(desc.sideTexels), Format::RGBA32UI, name + " codes"}),
      high(device, {Square(desc.sideTexels), Format::RGBA32UI, name + " codes, upper words"}),
      table(device, {.extent = Square(desc.sideTexels), .precision = SATPrecision::U64, .order = desc.order}) {}

DualParaboloidTables::DualParaboloidTables(Device& device, const DualParaboloidTablesDesc& desc)
    : m_desc(desc),
      m_codeScale(CodeScaleOf(desc)),
      m_encode(device, Quad("dp_encode.ps", 2, Format::RGBA32UI)),
      m_faces{Face(device, desc, kFaceNames[0]), Face(device, desc, kFaceNames[1])} {}

TexelWords DualParaboloidTables::RecordFace(CommandList& commands, Face& face, const Image& source) {
    const DPFaceConstants constants{0, static_cast<int>(m_desc.sideTexels), m_codeScale, m_desc.largestLight};
    commands.Draw({.name = "encode",
                   .pipeline = m_encode,
                   .reads = {{"face", &source}},
                   .writes = {&face.low, &face.high},
                   .constants = ConstantBytes(constants)});
    return face.table.Record(commands, TexelWords(face.low, face.high));
}

DualParaboloidWords DualParaboloidTables::Record(CommandList& commands, const DualParaboloidFaces& faces) {
    return {RecordFace(commands, m_faces[0], *faces.front), RecordFace(commands, m_faces[1], *faces.back)};
}

}  // namespace boxcar
