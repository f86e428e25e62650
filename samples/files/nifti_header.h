// What a NIfTI file says before its voxels, and how its axes lie in the world.
#pragma once

#include <nifti2_io.h>

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "samples/files/unpack.h"

namespace boxcar {

struct NiftiHeader {
    nifti_2_header fields;  // also those of NIfTI-1, which are fewer bits wide
    bool isSwapped;         // the file's numbers are of the other byte order
    bool isPair;            // the voxels are in another file
};

// What a header's first bytes tell. Throws Error, without the file's name: they are no header's.
struct NiftiStart {
    size_t headerBytes;
    bool isSwapped;
};
NiftiStart StartOf(ByteView start);

// Reads the header of NIfTI-1 or NIfTI-2. Throws Error, without the file's name: it is none.
NiftiHeader ReadNiftiHeader(Unpacker& source);

// Bytes of a file before its voxels: from the header's end to them.
uint64_t BytesBeforeVoxels(const NiftiHeader& header);

// How voxels as the file stores them come to lie along the world's axes: x to the right, y to the front, z up, as the
// body's own sides are.
struct NiftiAxes {
    std::array<int, 3> stored = {0, 1, 2};  // the file's axis that lies nearest to each of the world's
    std::array<bool, 3> isReversed = {};    // and whether it runs against it
    glm::dvec3 sides{1};                    // of a voxel along them, in the file's unit
    glm::mat3 turn{1};      // what is left: a rotation of less than 90 degrees, from them to the world
    bool hasShear = false;  // and a shear, which is left out
    std::string what;       // all that in a line
};

// The sform where it has one, else the qform, else the voxel sizes alone, as the standard prefers them; one that is
// not finite, or flat, is none. Up to 1e-4 of a turn between two axes is taken for a rounding.
//
// NIfTI-1 standard, "3D image (volume) orientation and location in space" (methods 3, 2 and 1)
NiftiAxes AxesOf(const nifti_2_header& fields);

}  // namespace boxcar
