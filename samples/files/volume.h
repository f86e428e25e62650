// Volumes in from files.
//
// Non-goals: writing; colors, complex numbers, several numbers at a voxel; where the body lies beyond how it is
// turned (a shear, the place of its origin).
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace boxcar {

// One number at every voxel. The axes are the world's, or those of the file that lie nearest to them: x towards the
// body's right, y to its front, z up.
struct Volume {
    uint32_t widthVoxels = 0;
    uint32_t heightVoxels = 0;
    uint32_t depthVoxels = 0;
    glm::vec3 voxelMillimetres{1};   // sides of a voxel
    std::vector<float> voxels = {};  // x goes fastest, then y
    glm::mat3 worldFromAxes{1};      // a rotation; 1 where the file's axes are parallel to the world's
    bool hasShear = false;           // in the file, which was left out
    uint64_t framesInFile = 1;
    std::string what = {};  // a line: extent, sides, which of the file's orientations was applied, the frame
};

struct VolumeReading {
    uint64_t frame = 0;            // which volume of a series; 0 is the first
    bool zeroesNotFinite = false;  // NaN and infinity become 0, else they are an Error
};

struct VolumeLimits {
    uint64_t maxBytes = uint64_t{1} << 30;   // of the file
    uint64_t maxVoxels = uint64_t{1} << 27;  // 512 a side
    uint32_t maxSideVoxels = 2048;
    uint64_t maxSkippedBytes = uint64_t{1} << 33;  // unpacked, before the frame
};

// Reads a NIfTI-1 or NIfTI-2 file, .nii or .nii.gz, or a pair of .hdr and .img, either packed or not: whole numbers
// of 8 to 64 bits, floats and doubles, in either byte order. Its scale (scl_slope, scl_inter) is applied; lengths in
// metres and micrometres become millimetres.
//
// Orientation: the sform where the file has one, else the qform, else the voxel sizes alone, with the axes as they
// are stored. Voxels are moved so that their axes are those that lie nearest to the world's, which is exact; the
// rotation that is left is worldFromAxes.
//
//   path  a file, or "-" for standard input; of a pair either file, whose names differ in the ending only
//
// Throws Error, one line that begins with the path: it cannot be read, is no such file, is one of a pair without the
// other, is cut off or damaged, holds colors or complex numbers, a voxel is not finite, or it is over a limit.
// Throws UsageError: it has no such frame. Memory: twice its voxels where they are moved.
Volume ReadVolume(const std::string& path, const VolumeReading& reading = {}, const VolumeLimits& limits = {});

// The same from memory, one file; `name` stands for the path in errors.
Volume DecodeVolume(std::span<const uint8_t> file, const std::string& name, const VolumeReading& reading = {},
                    const VolumeLimits& limits = {});

}  // namespace boxcar
