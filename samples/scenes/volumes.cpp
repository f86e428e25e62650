#include "samples/scenes/volumes.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

extern "C" const uint8_t scenes_ch2bet_nii_gz[], scenes_ch2bet_nii_gz_end[];

namespace boxcar {

Volume MarschnerLobb(uint32_t side) {
    constexpr double kAlpha = 0.25, kFrequency = 6, kPi = glm::pi<double>();
    Volume volume{.widthVoxels = side, .heightVoxels = side, .depthVoxels = side};
    volume.what = fmt::format("{0} x {0} x {0} voxels, computed", side);
    const auto at = [&](uint32_t i) { return 2 * (i + 0.5) / side - 1; };
    for (uint32_t z = 0; z < side; z++)
        for (uint32_t y = 0; y < side; y++)
            for (uint32_t x = 0; x < side; x++) {
                const double radius = std::hypot(at(x), at(y));
                const double wave = std::cos(2 * kPi * kFrequency * std::cos(kPi * radius / 2));
                const double value = (1 - std::sin(kPi * at(z) / 2) + kAlpha * (1 + wave)) / (2 * (1 + kAlpha));
                volume.voxels.push_back(static_cast<float>(255 * value));
            }
    return volume;
}

Volume SampleVolume(std::string_view name) {
    if (name == "marschner-lobb") return MarschnerLobb();
    return DecodeVolume({scenes_ch2bet_nii_gz, scenes_ch2bet_nii_gz_end}, "head");
}

}  // namespace boxcar
