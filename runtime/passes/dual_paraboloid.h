// The sphere of directions on two square pictures, and their summed-area tables.
//
//   cube map  ->  DualParaboloid  ->  front, back  ->  DualParaboloidTables  ->  tables of both
//
// hlsl/boxcar/dual_paraboloid.hlsli says how a direction lies on a face; dual_paraboloid_sat.hlsli reads the tables.
//
// Hensley 2005, sect. 5.1; Scheuermann 2005
#pragma once

#include <array>
#include <optional>

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
    float largestLight = 65504;  // brighter light becomes this
    float darkestLight = 65504;  // light to be right to 1 % all over the faces; only orders 2 and 3 ask for it
};

// The tables of both faces.
struct DualParaboloidWords {
    TexelWords front;
    TexelWords back;
};

// What readers of the tables need.
struct DualParaboloidSums {
    DualParaboloidWords tables;
    std::optional<DualParaboloidWords> fine;  // what rounding left over, kDPFineScale times as fine; read as signed

    // Color codes of light 1 and weight code 1: what readers divide by. Light is coded in steps of 1 over 4096 times
    // this, relative to the weight of the middle texel.
    float codeScale;
};

// Exact tables of both faces: light times weight in rgb, the weight in alpha, in whole numbers of 64 bits: 40 bits a
// code or as many as the widest kernel leaves (hlsl/boxcar/dual_paraboloid_range.h). Where these are too few for the
// darkest light there are fine tables too, at twice the time. Device memory: 192 bytes a texel of a face; from the
// first fine tables on 384. Move-only. Not thread-safe.
class DualParaboloidTables {
public:
    // `device` must live on.
    DualParaboloidTables(Device& device, const DualParaboloidTablesDesc& desc);

    // Readable up to the next Record().
    //
    //   largestTexels  of the boxes that kernels are made of; at the most sideTexels
    //
    // Throws Error: sums under the largest kernel leave less than 23 bits to a code.
    DualParaboloidSums Record(CommandList& commands, const DualParaboloidFaces& faces, uint32_t largestTexels);

private:
    // The codes of a face and their table.
    struct Face {
        Face(Device& device, const DualParaboloidTablesDesc& desc, const std::string& name);

        WordImages codes;
        SummedAreaTable table;
    };

    // Both faces in codes, or what rounding left over of them.
    struct Set {
        Set(Device& device, const DualParaboloidTablesDesc& desc, bool isFine);

        Pipeline encode;
        std::array<Face, 2> faces;
    };

    DualParaboloidWords RecordSet(CommandList& commands, Set& set, const DualParaboloidFaces& faces, float codeScale);
    TexelWords RecordFace(CommandList& commands, Set& set, size_t face, const Image& source, float codeScale);

    Device& m_device;
    DualParaboloidTablesDesc m_desc;
    Set m_coarse;
    std::optional<Set> m_fine;
};

}  // namespace boxcar
