// The mean over a box, from its definition: every texel counts as much as the box covers of it. In double, texel by
// texel, without a table: slow and obvious. Written from Crow 1984, sect. 2.1 and the contract in `boxcar filter
// --help`, not from the shaders.
#pragma once

#include <algorithm>
#include <glm/vec4.hpp>
#include <vector>

namespace boxcar::reference {

struct DoubleImage {
    int width = 0;
    int height = 0;
    std::vector<glm::dvec4> texels;

    const glm::dvec4& At(int x, int y) const { return texels[static_cast<size_t>(y) * width + x]; }
};

enum class Edge { Clip, Zero };

// How much of [texel, texel + 1) lies in [lo, hi).
inline double Coverage(int texel, double lo, double hi) {
    return std::max(0.0, std::min(hi, texel + 1.0) - std::max(lo, static_cast<double>(texel)));
}

// The mean over the box of `widthTexels` x `heightTexels` round the point (centreX, centreY), in edge coordinates.
inline glm::dvec4 BoxMean(const DoubleImage& image, double centreX, double centreY, double widthTexels,
                          double heightTexels, Edge edge) {
    const double w = std::max(widthTexels, 1.0);
    const double h = std::max(heightTexels, 1.0);
    const double left = centreX - w / 2, right = centreX + w / 2;
    const double top = centreY - h / 2, bottom = centreY + h / 2;
    glm::dvec4 sum(0);
    double covered = 0;
    for (int y = std::max(0, static_cast<int>(top)); y < image.height && y < bottom; y++) {
        const double rows = Coverage(y, top, bottom);
        for (int x = std::max(0, static_cast<int>(left)); x < image.width && x < right; x++) {
            const double weight = rows * Coverage(x, left, right);
            sum += weight * image.At(x, y);
            covered += weight;
        }
    }
    if (edge == Edge::Zero) return sum / (w * h);
    return covered > 0 ? sum / covered : glm::dvec4(0);
}

// T(x, y) = the sum of all texels left of and above (x, y), itself included.
inline DoubleImage SummedAreaTable(const DoubleImage& image) {
    DoubleImage table{image.width, image.height, {}};
    std::vector<glm::dvec4> columnSums(image.width, glm::dvec4(0));
    for (int y = 0; y < image.height; y++) {
        glm::dvec4 sum(0);
        for (int x = 0; x < image.width; x++) {
            columnSums[x] += image.At(x, y);
            sum += columnSums[x];
            table.texels.push_back(sum);
        }
    }
    return table;
}

}  // namespace boxcar::reference
