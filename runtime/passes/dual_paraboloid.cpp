#include "runtime/passes/dual_paraboloid.h"

#include <algorithm>
#include <cmath>

#include "hlsl/boxcar/dual_paraboloid_range.h"
#include "hlsl/constants/dp_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "tools/base/error.h"

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
double LargestCode(uint32_t order, uint32_t largestTexels) {
    const double mass = std::pow(static_cast<double>(largestTexels), 2.0 * order);
    const double largestCode = std::min(std::ldexp(1.0, 40), std::ldexp(1.0, 63) / mass);
    // A fine table's sums, of codes up to half of kDPFineScale, fit then too.
    if (largestCode < kDPFineScale)
        throw Error("kernels of order {} of boxes of {} texels: their sums leave less than 23 of 64 bits to a code",
                    order, largestTexels);
    return largestCode;
}

// At the rim a texel weighs a quarter, so that half a step of the codes is up to two of the light in the middle: 256
// steps leave less than 1 %.
bool NeedsFine(const DualParaboloidTablesDesc& desc, double largestCode) {
    constexpr double kSteps = 256;
    return desc.order > 1 &&
           largestCode * static_cast<double>(desc.darkestLight) < kSteps * static_cast<double>(desc.largestLight);
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
    : codes(device, SATPrecision::U64, Square(desc.sideTexels), name + " codes"),
      table(device, {.extent = Square(desc.sideTexels), .precision = SATPrecision::U64, .order = desc.order}) {}

DualParaboloidTables::Set::Set(Device& device, const DualParaboloidTablesDesc& desc, bool isFine)
    : encode(device, QuadShaders(fmt::format("dp_encode.ps.FINE={:d}", isFine), WordFormats(SATPrecision::U64))),
      faces{Face(device, desc, kFaceNames[0]), Face(device, desc, kFaceNames[1])} {}

DualParaboloidTables::DualParaboloidTables(Device& device, const DualParaboloidTablesDesc& desc)
    : m_device(device), m_desc(desc), m_coarse(device, desc, false) {}

TexelWords DualParaboloidTables::RecordFace(CommandList& commands, Set& set, size_t face, const Image& source,
                                            float codeScale) {
    Face& target = set.faces.at(face);
    const DPFaceConstants constants{0, static_cast<int>(m_desc.sideTexels), codeScale, m_desc.largestLight};
    commands.Draw({.name = "encode",
                   .pipeline = set.encode,
                   .reads = {{"face", &source}},
                   .writes = target.codes.Writes(),
                   .constants = ConstantBytes(constants)});
    return target.table.Record(commands, target.codes);
}

DualParaboloidWords DualParaboloidTables::RecordSet(CommandList& commands, Set& set, const DualParaboloidFaces& faces,
                                                    float codeScale) {
    return {RecordFace(commands, set, 0, *faces.front, codeScale),
            RecordFace(commands, set, 1, *faces.back, codeScale)};
}

DualParaboloidSums DualParaboloidTables::Record(CommandList& commands, const DualParaboloidFaces& faces,
                                                uint32_t largestTexels) {
    BOXCAR_ASSERT(largestTexels >= 1 && largestTexels <= m_desc.sideTexels);
    const double largestCode = LargestCode(m_desc.order, largestTexels);
    const auto codeScale =
        static_cast<float>(largestCode / (kLargestWeight * static_cast<double>(m_desc.largestLight)));
    DualParaboloidSums sums{RecordSet(commands, m_coarse, faces, codeScale), {}, codeScale};
    if (NeedsFine(m_desc, largestCode)) {
        if (!m_fine) m_fine.emplace(m_device, m_desc, true);
        sums.fine = RecordSet(commands, *m_fine, faces, codeScale);
    }
    return sums;
}

}  // namespace boxcar
