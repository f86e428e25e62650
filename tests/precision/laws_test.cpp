// What the papers promise and what follows from the arithmetic, measured on the device: to 1 dB, unless it says
// otherwise. docs/precision.md says where a law fails.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>

#include "tests/precision/subjects.h"
#include "tests/reference/precision.h"

namespace boxcar {
namespace {

double Decibels(double ratio) {
    return 20 * std::log10(ratio);
}

double Snr(Meter& meter, const Case& setup) {
    const auto measured = meter.Measure(setup).snrDb;
    EXPECT_TRUE(measured) << "overflow";
    return measured.value_or(0);
}

double Snr(const Subject& subject, const Case& setup) {
    Meter meter(TestDevice(), subject, {1});
    return Snr(meter, setup);
}

// Root mean square of half the distance between neighbours of float32 at the entries of the table of `image` less
// `bias`: what rounding an entry costs.
double EntrySpacing(const Subject& subject, glm::vec4 bias) {
    reference::DoubleImage image = ToDouble(subject.extent, subject.texels);
    for (glm::dvec4& texel : image.texels)
        texel -= glm::dvec4(bias);
    double squares = 0;
    for (const glm::dvec4& entry : reference::SummedAreaTable(image).texels)
        for (int c = 0; c < subject.colors; c++)
            squares += entry[c] == 0 ? 0 : std::pow(std::ldexp(1.0, std::ilogb(entry[c]) - 24), 2);
    return std::sqrt(squares / (static_cast<double>(image.texels.size()) * subject.colors));
}

// 6.02 dB a mantissa bit: 10, 16 and 23 of them.
TEST(PrecisionLaws, AMantissaBitIsWorthSixDecibels) {
    for (const char* name : {"fruits.jpg", "building.jpg"}) {
        Meter meter(TestDevice(), Photograph(name, {0, 0, 256, 240}), {1});
        for (const Bias bias : {Bias::None, Bias::Half, Bias::Mean}) {
            for (const Origin origin : {Origin::Corner, Origin::Center}) {
                const double fp16 = Snr(meter, {Precision::Fp16, bias, origin, 2});
                const double fp24 = Snr(meter, {Precision::Fp24, bias, origin, 2});
                const double fp32 = Snr(meter, {Precision::Fp32, bias, origin, 2});
                EXPECT_NEAR(fp24 - fp16, Decibels(1 << 6), 1) << name << Name(bias) << Name(origin);
                EXPECT_NEAR(fp32 - fp24, Decibels(1 << 7), 1) << name << Name(bias) << Name(origin);
            }
        }
    }
}

// Entries grow as N^2, and their spacing with them.
TEST(PrecisionLaws, TwiceTheSideCostsTwelveDecibels) {
    double last = 0;
    for (const uint32_t side : {64u, 128u, 256u, 512u}) {
        const double snr = Snr(Noise({side, side}, 1), {.precision = Precision::Fp24});
        if (side > 64) EXPECT_NEAR(last - snr, Decibels(4), 1) << side;
        last = snr;
    }
}

// Hensley 2005, sect. 4.2.2: double the width and height for a given precision, or a quarter of the entries' size.
TEST(PrecisionLaws, OriginInTheCenterGainsTwelveDecibels) {
    for (const Subject& subject :
         {Photograph("fruits.jpg"), Photograph("building.jpg"), Noise({256, 256}, 2), Constant({300, 200}, 200)}) {
        Meter meter(TestDevice(), subject, {1});
        const double corner = Snr(meter, {.precision = Precision::Fp24});
        const double center = Snr(meter, {.precision = Precision::Fp24, .origin = Origin::Center});
        EXPECT_NEAR(center - corner, Decibels(4), 1) << subject.extent.widthTexels;
    }
}

TEST(PrecisionLaws, MeanGains) {
    for (const char* name : {"fruits.jpg", "building.jpg"}) {
        for (const Rect crop : {Rect{}, Rect{0, 0, 256, 256}, Rect{128, 128, 256, 256}, Rect{200, 150, 128, 128}}) {
            const Subject subject = Photograph(name, crop);
            Meter meter(TestDevice(), subject, {1});
            const double none = Snr(meter, {});
            const double half = Snr(meter, {.bias = Bias::Half});
            const double mean = Snr(meter, {.bias = Bias::Mean});
            const double predicted =
                Decibels(EntrySpacing(subject, glm::vec4(0)) / EntrySpacing(subject, subject.mean));
            const double predictedHalf =
                Decibels(EntrySpacing(subject, glm::vec4(0)) / EntrySpacing(subject, glm::vec4(0.5f)));
            fmt::print(
                "{} {}: none {:.2f} half {:+.2f} ({:+.2f}) mean {:+.2f} predicted {:+.2f} both {:+.2f}; mean {:.2f} "
                "{:.2f} {:.2f}\n",
                name, crop.widthTexels, none, half - none, predictedHalf, mean - none, predicted,
                Snr(meter, {.bias = Bias::Mean, .origin = Origin::Center}) - none, subject.mean.x, subject.mean.y,
                subject.mean.z);
        }
    }
}

TEST(PrecisionLaws, DarkHalf) {
    for (const auto [low, high] : {std::pair{0u, 92u}, std::pair{40u, 52u}, std::pair{46u, 46u}}) {
        for (const uint32_t side : {64u, 128u, 256u, 512u}) {
            const Subject subject = Noise({side, side}, 5, low, high);
            Meter meter(TestDevice(), subject, {1});
            const double none = Snr(meter, {.precision = Precision::Fp24});
            const double half = Snr(meter, {.precision = Precision::Fp24, .bias = Bias::Half});
            fmt::print("{} {} {}: none {:.2f} half {:+.2f} predicted {:+.2f} mean {:.3f}\n", low, high, side, none,
                       half - none,
                       Decibels(EntrySpacing(subject, glm::vec4(0)) / EntrySpacing(subject, glm::vec4(0.5f))),
                       subject.mean.x);
        }
    }
}

}  // namespace
}  // namespace boxcar
