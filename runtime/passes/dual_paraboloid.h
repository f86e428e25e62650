// The sphere of directions on two square pictures, and their summed-area tables.
//
//   cube map  ->  DualParaboloid  ->  front, back  ->  DualParaboloidTables  ->  tables of both
//
// hlsl/boxcar/dual_paraboloid.hlsli says how a direction lies on a face; dual_paraboloid_sat.hlsli reads the tables.
//
// Hensley 2005, sect. 5.1; Scheuermann 2005
#pragma once

#include <array>

#include "runtime/passes/summed_area_table.h"

namespace boxcar {

// Where a face's directions come from. Both give the same bits.
enum class DPMapping {
    Arithmetic,  // computed for each texel
    Lookup,      // from a texture, drawn once: 32 bytes a texel of a face more
};

struct DualParaboloidFaces {
    const Image* front;  // looks along -z
    const Image* back;   // looks along +z
};

// Holds the faces: 32 bytes of device memory a texel. Move-only. Not thread-safe.
class DualParaboloid {
public:
    // sideTexels: of a face. Throws Error: 0 or over the device's limit.
    DualParaboloid(Device& device, uint32_t sideTexels, DPMapping mapping = DPMapping::Arithmetic);

    // Returns the faces, RGBA32F: light; alpha is the share of the sphere that the texel stands for, over that of the
    // middle one (DPWeight). Beyond its disc a face holds light too, and counts nothing.
    //
    //   cube  of 6 layers
    DualParaboloidFaces Record(CommandList& commands, const Image& cube);

private:
    Pipeline m_pipeline;
    std::vector<Image> m_faces;
    std::vector<Image> m_directions;  // Lookup only
};

struct DualParaboloidTablesDesc {
    uint32_t sideTexels = 256;  // of a face
    uint32_t order = 1;
    float largestLight = 65504;    // brighter light becomes this
    uint32_t largestTexels = 256;  // the largest box that a kernel is made of; at the most sideTexels
};

struct DualParaboloidWords {
    TexelWords front;
    TexelWords back;
};

// Exact tables of both faces: light times weight in rgb, the weight in alpha, in whole numbers of 64 bits. Device
// memory: 192 bytes a texel of a face. Move-only. Not thread-safe.
class DualParaboloidTables {
public:
    // Throws Error: the sum under the largest kernel does not fit into 64 bits, whatever the light.
    DualParaboloidTables(Device& device, const DualParaboloidTablesDesc& desc);

    DualParaboloidWords Record(CommandList& commands, const DualParaboloidFaces& faces);

    // Colour codes of light 1 and weight code 1: what readers divide by. Light is coded in steps of 1 over 4096 times
    // this, relative to the weight of the middle texel.
    float CodeScale() const { return m_codeScale; }

    const DualParaboloidTablesDesc& Desc() const { return m_desc; }

private:
    // The codes of a face and their table.
    struct Face {
        Face(Device& device, const DualParaboloidTablesDesc& desc, const std::string& name);

        Image low, high;
        SummedAreaTable table;
    };

    TexelWords RecordFace(CommandList& commands, Face& face, const Image& source);

    DualParaboloidTablesDesc m_desc;
    float m_codeScale;
    Pipeline m_encode;
    std::array<Face, 2> m_faces;
};

}  // namespace boxcar
