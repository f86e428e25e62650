#include "runtime/passes/dual_paraboloid.h"

#include <algorithm>
#include <cmath>

#include "hlsl/constants/dp_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

constexpr double kLargestWeight = 4096;
constexpr const char* kFaceNames[] = {"front", "back"};

Extent2D Square(uint32_t side) {
    return {side, side};
}

DPFaceConstants FaceConstants(size_t face, uint32_t sideTexels) {
    return {static_cast<int>(face), static_cast<int>(sideTexels), 0, 0};
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
    : m_pipeline(device, QuadShaders(fmt::format("dp_from_cube.ps.LOOKUP={:d}", mapping == DPMapping::Lookup))) {
    for (const std::string name : kFaceNames)
        m_faces.emplace_back(device, ImageDesc{Square(sideTexels), Format::RGBA32F, name + " face"});
    if (mapping == DPMapping::Arithmetic) return;
    for (const std::string name : kFaceNames)
        m_directions.emplace_back(device, ImageDesc{Square(sideTexels), Format::RGBA32F, name + " directions"});
    const Pipeline drawDirections(device, QuadShaders("dp_directions.ps"));
    CommandList commands(device);
    for (size_t face = 0; face < 2; face++) {
        const DPFaceConstants constants = FaceConstants(face, sideTexels);
        commands.Draw({.name = "directions",
                       .pipeline = drawDirections,
                       .writes = {&m_directions[face]},
                       .constants = ConstantBytes(constants)});
    }
    commands.SubmitAndWait();
}

DualParaboloidFaces DualParaboloid::Record(CommandList& commands, const Image& cube) {
    BOXCAR_ASSERT(cube.Desc().layers == 6);
    for (size_t face = 0; face < 2; face++) {
        const DPFaceConstants constants = FaceConstants(face, m_faces[face].Extent().widthTexels);
        Pass pass{
            .name = kFaceNames[face], .pipeline = m_pipeline, .reads = {{"cube", &cube}}, .writes = {&m_faces[face]}};
        if (m_directions.empty())
            pass.constants = ConstantBytes(constants);
        else
            pass.reads.push_back({"directions", &m_directions[face]});
        commands.Draw(pass);
    }
    return {&m_faces[0], &m_faces[1]};
}

DualParaboloidTables::Face::Face(Device& device, const DualParaboloidTablesDesc& desc, const std::string& name)
    : low(device, {Square(desc.sideTexels), Format::RGBA32UI, name + " codes"}),
      high(device, {Square(desc.sideTexels), Format::RGBA32UI, name + " codes, upper words"}),
      table(device, {.extent = Square(desc.sideTexels), .precision = SATPrecision::U64, .order = desc.order}) {}

DualParaboloidTables::DualParaboloidTables(Device& device, const DualParaboloidTablesDesc& desc)
    : m_desc(desc),
      m_codeScale(CodeScaleOf(desc)),
      m_encode(device, QuadShaders("dp_encode.ps", {Format::RGBA32UI, Format::RGBA32UI})),
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
