// The cubic B-spline of an image, from its definition: the sum of texels times the basis function at their distances,
// and that function's derivatives, in double. The basis is the box convolved with itself, by the recursion of de
// Boor; texels outside are those of the edge.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/reference/box.h"

namespace boxcar::reference {

// The B-spline of degree n about 0.
inline double BSpline(int degree, double x) {
    if (degree == 0) return x >= -0.5 && x < 0.5 ? 1 : 0;
    const double half = (degree + 1) / 2.0;
    return ((half + x) * BSpline(degree - 1, x + 0.5) + (half - x) * BSpline(degree - 1, x - 0.5)) / degree;
}

// Its derivative of order 0, 1 or 2: differences of splines of lower degree.
inline double BSplineDerivative(int order, double x) {
    if (order == 0) return BSpline(3, x);
    if (order == 1) return BSpline(2, x + 0.5) - BSpline(2, x - 0.5);
    return BSpline(1, x + 1) - 2 * BSpline(1, x) + BSpline(1, x - 1);
}

// Keys' cubic with a = -1/2, as Catmull and Rom have it.
inline double CatmullRom(double x) {
    const double a = std::abs(x);
    if (a < 1) return 1.5 * a * a * a - 2.5 * a * a + 1;
    return a < 2 ? -0.5 * a * a * a + 2.5 * a * a - 4 * a + 2 : 0;
}

// The sum over texels at the point (x, y), in edge coordinates, of texel times kernelX times kernelY at their
// distances.
template <typename KernelX, typename KernelY>
glm::dvec4 CubicSum(const DoubleImage& image, double x, double y, KernelX kernelX, KernelY kernelY) {
    glm::dvec4 sum(0);
    const int left = static_cast<int>(std::floor(x)) - 3, top = static_cast<int>(std::floor(y)) - 3;
    for (int j = top; j < top + 7; j++)
        for (int i = left; i < left + 7; i++)
            sum += kernelX(x - (i + 0.5)) * kernelY(y - (j + 0.5)) *
                   image.At(std::clamp(i, 0, image.width - 1), std::clamp(j, 0, image.height - 1));
    return sum;
}

// The coefficients whose cubic B-spline goes through f, along a line that is mirrored at its ends: solves
// (c[i - 1] + 4 c[i] + c[i + 1]) / 6 = f[i] by Thomas' elimination.
inline std::vector<double> SolveLine(const std::vector<double>& f) {
    const size_t n = f.size();
    std::vector<double> diagonal(n, 4), right(n);
    diagonal[0] += 1;
    diagonal[n - 1] += 1;
    for (size_t i = 0; i < n; i++)
        right[i] = 6 * f[i];
    for (size_t i = 1; i < n; i++) {
        const double factor = 1 / diagonal[i - 1];
        diagonal[i] -= factor;
        right[i] -= factor * right[i - 1];
    }
    std::vector<double> c(n);
    for (size_t i = n; i-- > 0;)
        c[i] = (right[i] - (i + 1 < n ? c[i + 1] : 0)) / diagonal[i];
    return c;
}

// The same for the rows of an image and then its columns.
inline DoubleImage SplineCoefficients(DoubleImage image) {
    const auto solve = [&](int start, int stride, int count) {
        for (int channel = 0; channel < 4; channel++) {
            std::vector<double> f;
            for (int i = 0; i < count; i++)
                f.push_back(image.texels[static_cast<size_t>(start + i * stride)][channel]);
            f = SolveLine(f);
            for (int i = 0; i < count; i++)
                image.texels[static_cast<size_t>(start + i * stride)][channel] = f[static_cast<size_t>(i)];
        }
    };
    for (int y = 0; y < image.height; y++)
        solve(y * image.width, 1, image.width);
    for (int x = 0; x < image.width; x++)
        solve(x, image.width, image.height);
    return image;
}

}  // namespace boxcar::reference
