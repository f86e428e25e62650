// Volumes in from files.
//
// Non-goals: writing; series of volumes, colours, complex numbers; where the patient lies (the file's transforms):
// axes are as the file stores them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace boxcar {

// One number at every voxel.
struct Volume {
    uint32_t widthVoxels = 0;
    uint32_t heightVoxels = 0;
    uint32_t depthVoxels = 0;
    glm::vec3 voxelMillimetres{1};  // sides of a voxel
    std::vector<float> voxels;      // x goes fastest, then y
};

struct VolumeLimits {
    uint64_t maxBytes = uint64_t{1} << 30;   // of the file
    uint64_t maxVoxels = uint64_t{1} << 27;  // 512 a side
    uint32_t maxSideVoxels = 2048;
};

// Reads a NIfTI-1 file, .nii or .nii.gz: whole numbers of 8 to 64 bits, floats and doubles, in either byte order. Its
// scale (scl_slope, scl_inter) is applied; lengths in metres and micrometres become millimetres.
//
//   path  a file, or "-" for standard input
//
// Throws Error, one line that begins with the path: it cannot be read, is no such file, is one of a pair of .hdr and
// .img, is cut off or damaged, holds several volumes, colours or complex numbers, a voxel is not finite, or it is
// over a limit.
Volume ReadVolume(const std::string& path, const VolumeLimits& limits = {});

// The same from memory; `name` stands for the path in errors.
Volume DecodeVolume(std::span<const uint8_t> file, const std::string& name, const VolumeLimits& limits = {});

}  // namespace boxcar
