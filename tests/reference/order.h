// Kernels of order 1 to 3 and discs, from their definitions: the image is constant on each texel, the kernel is
// integrated over every texel it touches, inside the picture or not. In double, without a table: slow and obvious.
// Written from Heckbert 1986, "Filtering by repeated integration": the kernel of order n is the box convolved n
// times, and so a piecewise polynomial of degree n - 1. Not written from the shaders.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "tests/reference/box.h"

namespace boxcar::reference {

enum class Border {
    Clip,    // divide by the part of the kernel that lies inside; 0 where none does
    Zero,    // 0 outside
    Repeat,  // .. y z | a b .. y z | a b ..
    Mirror,  // .. b a | a b .. y z | z y ..
};

constexpr int kOutside = -1;

// Which of `size` texels stands at `texel` on the infinite axis, or kOutside.
inline int MapTexel(int texel, int size, Border border) {
    if (texel >= 0 && texel < size) return texel;
    if (border == Border::Clip || border == Border::Zero) return kOutside;
    const int period = border == Border::Repeat ? size : 2 * size;
    const int at = (texel % period + period) % period;
    return at < size ? at : period - 1 - at;
}

// The unit-area kernel (Heckbert 1986: box, tent, parabolic) at t, in units of W from the centre.
inline double KernelDensity(int order, double t) {
    if (order < 1 || order > 3) throw std::invalid_argument("order is none of 1, 2, 3");
    const double d = std::abs(t);
    if (d >= order / 2.0) return 0;
    if (order == 1) return 1;
    if (order == 2) return 1 - d;
    return d < 0.5 ? 0.75 - d * d : (1.5 - d) * (1.5 - d) / 2;
}

// Its integral from minus infinity to t.
inline double KernelCdf(int order, double t) {
    if (order < 1 || order > 3) throw std::invalid_argument("order is none of 1, 2, 3");
    if (t > 0) return 1 - KernelCdf(order, -t);
    const double s = t + order / 2.0;  // from the kernel's left end
    if (s <= 0) return 0;
    if (order == 1) return s;
    if (order == 2) return s * s / 2;
    return s <= 1 ? s * s * s / 6 : 0.5 + 0.75 * t - t * t * t / 3;
}

// Its integral from lo to hi. The right half is measured from the right, where the numbers are small: a sliver of the
// tail keeps its digits.
inline double KernelMass(int order, double lo, double hi) {
    if (lo > 0) return KernelCdf(order, -lo) - KernelCdf(order, -hi);
    return KernelCdf(order, hi) - KernelCdf(order, lo);
}

// weights[i] belongs to the texel first + i of the infinite axis.
struct AxisWeights {
    int first = 0;
    std::vector<double> weights;
};

// How much of the kernel round `centre` (edge coordinates) each texel gets: all the texels it touches; sum 1.
inline AxisWeights KernelWeights(int order, double centre, double widthTexels) {
    const double w = std::max(widthTexels, 1.0);
    const int first = static_cast<int>(std::floor(centre - order * w / 2));
    const int end = static_cast<int>(std::ceil(centre + order * w / 2));
    AxisWeights axis{first, {}};
    for (int texel = first; texel < end; texel++)
        axis.weights.push_back(KernelMass(order, (texel - centre) / w, (texel + 1 - centre) / w));
    return axis;
}

// How much of [lo, hi) each texel covers; sum hi - lo.
inline AxisWeights CoverageWeights(double lo, double hi) {
    AxisWeights axis{static_cast<int>(std::floor(lo)), {}};
    for (int texel = axis.first; texel < hi; texel++)
        axis.weights.push_back(Coverage(texel, lo, hi));
    return axis;
}

struct WeightedSum {
    glm::dvec4 sum = glm::dvec4(0);
    double inside = 0;  // the weight of the texels that are not kOutside
};

// The sum over the infinite plane of texel * column weight * row weight.
inline WeightedSum SumOverPlane(const DoubleImage& image, const AxisWeights& columns, const AxisWeights& rows,
                                Border border) {
    WeightedSum result;
    for (size_t j = 0; j < rows.weights.size(); j++) {
        const int y = MapTexel(rows.first + static_cast<int>(j), image.height, border);
        if (y == kOutside) continue;
        for (size_t i = 0; i < columns.weights.size(); i++) {
            const int x = MapTexel(columns.first + static_cast<int>(i), image.width, border);
            if (x == kOutside) continue;
            const double weight = columns.weights[i] * rows.weights[j];
            result.sum += weight * image.At(x, y);
            result.inside += weight;
        }
    }
    return result;
}

// The integral of the image times the kernel round the point (centreX, centreY), in edge coordinates. The kernel is
// `order` boxes of widthTexels x heightTexels convolved: it reaches order / 2 times as far from there as one of them.
inline glm::dvec4 FilterMean(const DoubleImage& image, int order, double centreX, double centreY, double widthTexels,
                             double heightTexels, Border border) {
    const WeightedSum all = SumOverPlane(image, KernelWeights(order, centreX, widthTexels),
                                         KernelWeights(order, centreY, heightTexels), border);
    if (border != Border::Clip) return all.sum;
    return all.inside > 0 ? all.sum / all.inside : glm::dvec4(0);
}

// The mean over `strips` rectangles of equal height that stand for the disc round (centreX, centreY): each is as wide
// as the disc is at the strip's middle. Diameters below 1 act as 1, strips may be as thin as they come. Clip divides
// by the rectangles' area inside the picture, the others by all of it (not by the disc's own).
inline glm::dvec4 DiscMean(const DoubleImage& image, double centreX, double centreY, double diameterTexels,
                           int strips, Border border) {
    if (strips < 1) throw std::invalid_argument("strips is below 1");
    const double diameter = std::max(diameterTexels, 1.0);
    glm::dvec4 sum(0);
    double area = 0;
    for (int k = 0; k < strips; k++) {
        const double top = -diameter / 2 + k * diameter / strips;
        const double bottom = -diameter / 2 + (k + 1) * diameter / strips;
        const double middle = (top + bottom) / 2;
        const double halfChord = std::sqrt(diameter * diameter / 4 - middle * middle);
        const WeightedSum strip = SumOverPlane(image, CoverageWeights(centreX - halfChord, centreX + halfChord),
                                               CoverageWeights(centreY + top, centreY + bottom), border);
        sum += strip.sum;
        area += border == Border::Clip ? strip.inside : 2 * halfChord * (bottom - top);
    }
    return area > 0 ? sum / area : glm::dvec4(0);
}

// Half the width at height y (1 at the bottom) of the regular polygon with corners on the unit circle, one at the
// top: between two corners the side is a line, so at y it is at the mean of their x, weighted by how near they are.
inline double PolygonHalfWidth(int sides, double y) {
    const auto corner = [&](int k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        return glm::dvec2(std::sin(angle), -std::cos(angle));
    };
    for (int k = 0; corner(k).x >= 0 && k < sides; k++) {
        const glm::dvec2 above = corner(k), below = corner(k + 1);
        if (y < above.y || y > below.y || below.y == above.y) continue;
        const double t = (y - above.y) / (below.y - above.y);
        return std::abs(above.x + t * (below.x - above.x));
    }
    return 0;
}

// DiscMean for a polygon.
inline glm::dvec4 PolygonMean(const DoubleImage& image, double centreX, double centreY, double diameterTexels,
                              int sides, int strips, Border border) {
    glm::dvec4 sum(0);
    double area = 0;
    for (int k = 0; k < strips; k++) {
        const double top = -diameterTexels / 2 + k * diameterTexels / strips;
        const double bottom = top + diameterTexels / strips;
        const double half = diameterTexels / 2 * PolygonHalfWidth(sides, (top + bottom) / diameterTexels);
        if (half == 0) continue;
        const WeightedSum strip = SumOverPlane(image, CoverageWeights(centreX - half, centreX + half),
                                               CoverageWeights(centreY + top, centreY + bottom), border);
        sum += strip.sum;
        area += border == Border::Clip ? strip.inside : 2 * half * (bottom - top);
    }
    return sum / area;
}

// |kernel - Gaussian| / |Gaussian| in the L2 norm over the plane, both of unit sum and the kernel as wide as high.
// Both are products of one function of x and one of y, so the square of the difference integrates to
// (int k^2)^2 - 2 (int k g)^2 + (int g^2)^2; the integrals by the midpoint rule on cells that end where the kernel's
// pieces do.
inline double RelativeL2ToGaussian(int order, double widthOverSigma) {
    const double step = widthOverSigma / 2 / 4096;
    const int cells = static_cast<int>(std::ceil(std::max(order * widthOverSigma / 2, 12.0) / step));
    double kk = 0, kg = 0, gg = 0;
    for (int cell = -cells; cell < cells; cell++) {
        const double x = (cell + 0.5) * step;  // in sigma
        const double k = KernelDensity(order, x / widthOverSigma) / widthOverSigma;
        const double g = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
        kk += k * k * step;
        kg += k * g * step;
        gg += g * g * step;
    }
    return std::sqrt(kk * kk - 2 * kg * kg + gg * gg) / gg;
}

}  // namespace boxcar::reference
