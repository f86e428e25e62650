// FilterMean of order.h and WholeSum of exact.h for every texel of a picture: kernels that are a product of one on x
// and one on y, one axis after the other. In double.
#pragma once

#include "tests/reference/exact.h"
#include "tests/reference/order.h"

namespace boxcar::reference {

// What the texel `first + i` from the kernel's own gets.
inline AxisWeights WeightsOf(int order, double widthTexels) {
    const double w = std::max(widthTexels, 1.0);
    const auto whole = static_cast<int>(w);
    if (w != whole || order * (whole - 1) % 2 != 0) return KernelWeights(order, 0.5, w);
    AxisWeights axis{-order * (whole - 1) / 2, {}};
    const double mass = std::pow(w, order);
    for (const __int128 weight : WholeWeights(order, whole))
        axis.weights.push_back(static_cast<double>(weight) / mass);
    return axis;
}

// The mean that one texel gets, on each axis from WeightsOf.
inline glm::dvec4 MeanAt(const DoubleImage& image, int order, int x, int y, double widthTexels, double heightTexels,
                         Border border) {
    AxisWeights columns = WeightsOf(order, widthTexels), rows = WeightsOf(order, heightTexels);
    columns.first += x;
    rows.first += y;
    const WeightedSum all = SumOverPlane(image, columns, rows, border);
    return border == Border::Clip ? all.sum / all.inside : all.sum;
}

// The weighted sums along one axis; with Clip divided by the weights inside.
inline DoubleImage AlongAxis(const DoubleImage& image, const AxisWeights& axis, bool alongX, Border border) {
    DoubleImage result{image.width, image.height, {}};
    result.texels.reserve(image.texels.size());
    const int size = alongX ? image.width : image.height;
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            glm::dvec4 sum(0);
            double inside = 0;
            for (size_t i = 0; i < axis.weights.size(); i++) {
                const int at = MapTexel((alongX ? x : y) + axis.first + static_cast<int>(i), size, border);
                if (at == kOutside) continue;
                sum += axis.weights[i] * (alongX ? image.At(at, y) : image.At(x, at));
                inside += axis.weights[i];
            }
            result.texels.push_back(border == Border::Clip ? sum / inside : sum);
        }
    return result;
}

inline DoubleImage FilteredPicture(const DoubleImage& image, int order, double widthTexels, double heightTexels,
                                   Border border) {
    return AlongAxis(AlongAxis(image, WeightsOf(order, widthTexels), true, border), WeightsOf(order, heightTexels),
                     false, border);
}

}  // namespace boxcar::reference
