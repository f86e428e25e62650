// Tensor products of kernels over a volume, and curvatures of implicit surfaces, in double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace boxcar::reference {

// x goes fastest.
struct VolumeOfDoubles {
    std::array<int, 3> extent;
    std::vector<double> voxels;
};

// At every voxel's centre plus `offset`: the sum of voxels times the kernels of their distances. A product of three,
// so axis by axis; voxels outside are those of the sides.
inline VolumeOfDoubles TensorSum(VolumeOfDoubles volume, const std::array<double, 3>& offset,
                                 const std::array<std::function<double(double)>, 3>& kernels) {
    int stride = 1;
    for (size_t axis = 0; axis < 3; axis++) {
        const int n = volume.extent[axis];
        std::vector<std::pair<int, double>> weights;  // of the voxel so many further on
        for (int i = -4; i <= 4; i++)
            weights.emplace_back(i, kernels[axis](offset[axis] - i));
        std::vector<double> sums(volume.voxels.size());
        for (size_t at = 0; at < sums.size(); at++) {
            const int i = static_cast<int>(at) / stride % n;
            for (const auto& [further, weight] : weights)
                sums[at] +=
                    weight * volume.voxels[at + static_cast<size_t>(std::clamp(i + further, 0, n - 1)) * stride -
                                           static_cast<size_t>(i) * stride];
        }
        volume.voxels = std::move(sums);
        stride *= n;
    }
    return volume;
}

// Principal curvatures of the surface f = const, larger first, its outside where f falls: by the invariants of
// G = -P H P / |g|, as the paper has them.
//
// Kindlmann 2003
inline std::pair<double, double> Curvatures(glm::dvec3 g, const glm::dmat3& h) {
    const double slope = glm::length(g);
    const glm::dvec3 n = -g / slope;
    const glm::dmat3 p = glm::dmat3(1) - glm::outerProduct(n, n);
    const glm::dmat3 G = p * h * p / -slope;
    double trace = 0, squares = 0;
    for (int i = 0; i < 3; i++) {
        trace += G[i][i];
        for (int j = 0; j < 3; j++)
            squares += G[i][j] * G[i][j];
    }
    const double root = std::sqrt(std::max(2 * squares - trace * trace, 0.0));
    return {(trace + root) / 2, (trace - root) / 2};
}

}  // namespace boxcar::reference
