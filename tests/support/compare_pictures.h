// Compares a picture with one that it should be like, and says where it is not.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "samples/files/picture.h"

namespace boxcar {

struct PictureTolerance {
    float perSample = 0;          // a sample that differs by more fails
    double failingFraction = 0;   // of the pixels that may have one
    double meanDifference = 1.0;  // of all samples: what the eye sees as another brightness
};

struct PictureDifference {
    bool isWithin = true;
    std::string report;  // one line: where it is worst, what was expected, what would have passed
    Picture picture;     // the magnitudes of the differences, the largest white
};

// `mask`: where it is 0 pixels are not looked at. All pictures have the same extent; channels in turn.
inline PictureDifference ComparePictures(const Picture& actual, const Picture& expected,
                                         const PictureTolerance& tolerance,
                                         const std::optional<std::vector<bool>>& mask = {}) {
    if (actual.widthTexels != expected.widthTexels || actual.heightTexels != expected.heightTexels ||
        actual.channels != expected.channels)
        return {false,
                fmt::format("{} x {} texels of {} channels, expected {} x {} of {}", actual.widthTexels,
                            actual.heightTexels, actual.channels, expected.widthTexels, expected.heightTexels,
                            expected.channels),
                {}};
    const size_t channels = actual.channels, pixels = actual.samples.size() / channels;
    PictureDifference difference{true, "", actual};
    float largest = 0;
    double sum = 0;
    size_t worst = 0, failing = 0, counted = 0;
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        float here = 0;
        for (size_t i = pixel * channels; i < (pixel + 1) * channels; i++) {
            float d = std::abs(actual.samples[i] - expected.samples[i]);
            if (std::isnan(d)) d = 1e9f;  // NaN is like nothing
            if (mask && !(*mask)[pixel]) d = 0;
            difference.picture.samples[i] = d;
            here = std::max(here, d);
            sum += d;
            if (d > largest) {
                largest = d;
                worst = i;
            }
        }
        counted += !mask || (*mask)[pixel];
        failing += here > tolerance.perSample;
    }
    const double fraction = counted > 0 ? static_cast<double>(failing) / static_cast<double>(counted) : 0;
    const double mean = counted > 0 ? sum / static_cast<double>(counted * channels) : 0;
    difference.isWithin = fraction <= tolerance.failingFraction && mean <= tolerance.meanDifference;
    const size_t at = worst / channels;
    difference.report = fmt::format(
        "worst at ({}, {}), channel {}: expected {}, actual {}; {} of {} pixels ({:.4f} %) differ by more than {}, "
        "the "
        "mean by {:.6f}; perSample {} would have passed",
        at % actual.widthTexels, at / actual.widthTexels, worst % channels, expected.samples[worst],
        actual.samples[worst], failing, counted, 100 * fraction, tolerance.perSample, mean, largest);
    for (float& sample : difference.picture.samples)
        sample = largest > 0 ? std::min(sample / largest, 1.0f) : 0;
    return difference;
}

}  // namespace boxcar
