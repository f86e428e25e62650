// How alike two pictures look: the structural similarity index, in double.
//
// Wang 2004 (8 x 8 windows of equal weight, at every place; K1 = 0.01, K2 = 0.03)
#pragma once

#include <algorithm>
#include <glm/vec4.hpp>
#include <vector>

#include "samples/files/color.h"

namespace boxcar::reference {

// What a display is given for light: 0 to 1.
inline double EncodedSrgb(double light) {
    return LinearToSrgb(std::clamp(light, 0.0, 1.0));
}

inline double EncodedLuminance(const glm::vec4& light) {
    return 0.2126 * EncodedSrgb(light.x) + 0.7152 * EncodedSrgb(light.y) + 0.0722 * EncodedSrgb(light.z);
}

// Mean over all windows that lie inside; 1 for equal pictures. Of luminance, sRGB-encoded; both sides at least 8
// texels.
inline double StructuralSimilarity(int width, int height, const std::vector<glm::vec4>& a,
                                   const std::vector<glm::vec4>& b) {
    constexpr int kSide = 8, kTexels = kSide * kSide;
    constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
    std::vector<double> x, y;
    for (const glm::vec4& texel : a)
        x.push_back(EncodedLuminance(texel));
    for (const glm::vec4& texel : b)
        y.push_back(EncodedLuminance(texel));
    double total = 0;
    for (int top = 0; top + kSide <= height; top++)
        for (int left = 0; left + kSide <= width; left++) {
            double sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
            for (int j = top; j < top + kSide; j++)
                for (int i = left; i < left + kSide; i++) {
                    const double p = x[static_cast<size_t>(j * width + i)], q = y[static_cast<size_t>(j * width + i)];
                    sx += p, sy += q, sxx += p * p, syy += q * q, sxy += p * q;
                }
            const double mx = sx / kTexels, my = sy / kTexels;
            const double vx = sxx / kTexels - mx * mx, vy = syy / kTexels - my * my, cov = sxy / kTexels - mx * my;
            total += (2 * mx * my + kC1) * (2 * cov + kC2) / ((mx * mx + my * my + kC1) * (vx + vy + kC2));
        }
    return total / ((width - kSide + 1) * (height - kSide + 1));
}

}  // namespace boxcar::reference
