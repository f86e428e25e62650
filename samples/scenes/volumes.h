// Volumes that come with the program.
#pragma once

#include <string_view>

#include "samples/files/volume.h"

namespace boxcar {

// The test signal of Marschner and Lobb: waves about the z axis, ever finer outwards, on a sine along z. `side`
// voxels of a millimetre on every axis, over (-1, 1); its values 0 to 1 are 0 to 255 here, as scans have them.
//
// Marschner and Lobb 1994, sect. 5 (40 voxels a side: just above what the waves need)
Volume MarschnerLobb(uint32_t side = 40);

// "head", an MRI of a brain, or "marschner-lobb".
Volume SampleVolume(std::string_view name);

}  // namespace boxcar
