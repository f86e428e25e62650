// What the papers promise and what follows from the arithmetic, measured on the device: to 1 dB, unless it says
// otherwise. docs/precision.md says where a law fails.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// 6.02 dB a mantissa bit: 10, 16 and 23 of them.
TEST(PrecisionLaws, AMantissaBitIsWorthSixDecibels) {
    for (const char* name : {"fruits.jpg", "building.jpg"}) {
        Meter meter(TestDevice(), Photograph(name, {0, 0, 256, 240}), {1});
        for (const Bias bias : {Bias::None, Bias::Half, Bias::Mean}) {
            for (const SATOrigin origin : {SATOrigin::Corner, SATOrigin::Center}) {
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
        if (side > 64) {
            EXPECT_NEAR(last - snr, Decibels(4), 1) << side;
        }
        last = snr;
    }
}

// Hensley 2005, sect. 4.2.2: double the width and height for a given precision, or a quarter of the entries' size.
TEST(PrecisionLaws, OriginInTheCenterGainsTwelveDecibels) {
    for (const Subject& subject :
         {Photograph("fruits.jpg"), Photograph("building.jpg"), Noise({256, 256}, 2), Constant({300, 200}, 200)}) {
        Meter meter(TestDevice(), subject, {1});
        const double corner = Snr(meter, {.precision = Precision::Fp24});
        const double center = Snr(meter, {.precision = Precision::Fp24, .origin = SATOrigin::Center});
        EXPECT_NEAR(center - corner, Decibels(4), 1) << subject.extent.widthTexels;
    }
}

double MeanGain(const Subject& subject, SATOrigin origin = SATOrigin::Corner) {
    Meter meter(TestDevice(), subject, {1});
    return Snr(meter, {.bias = Bias::Mean, .origin = origin}) - Snr(meter, {});
}

constexpr Rect kFlatWall{200, 150, 128, 128};

// Hensley 2005, sect. 4: "up to 31 dB". The mean alone: 13 to 29 dB on these photographs; with the origin in the
// centre 21 to 31.
TEST(PrecisionLaws, MeanGainsThirteenToThirtyDecibelsOnPhotographs) {
    double most = 0;
    for (const char* name : {"fruits.jpg", "building.jpg"}) {
        for (const Rect crop : {Rect{}, Rect{0, 0, 256, 256}, Rect{128, 128, 256, 256}, kFlatWall}) {
            const Subject subject = Photograph(name, crop);
            const double mean = MeanGain(subject);
            const double both = MeanGain(subject, SATOrigin::Center);
            most = std::max(most, both);
            EXPECT_GT(mean, 13) << name << ", " << crop.widthTexels;
            EXPECT_LT(mean, 30) << name << ", " << crop.widthTexels;
            EXPECT_GT(both, 21) << name << ", " << crop.widthTexels;
        }
    }
    EXPECT_NEAR(most, 31, 1);
}

// Why not more: rows and regions that differ from the mean still add up. The same texels in any order have none.
TEST(PrecisionLaws, LargeFeaturesTakeTheGainOfTheMeanAway) {
    Subject subject = Photograph("fruits.jpg");
    const double gain = MeanGain(subject);
    std::shuffle(subject.texels.begin(), subject.texels.end(), std::mt19937(3));
    EXPECT_GT(MeanGain(subject), gain + 15);
}

// Entries shrink or grow by |mean - 0.5| / mean.
TEST(PrecisionLaws, HalfHurtsADarkPicture) {
    for (const auto& [low, high] : {std::pair{0u, 92u}, std::pair{40u, 52u}}) {  // a mean of 0.18
        Meter meter(TestDevice(), Noise({256, 256}, 5, low, high), {1});
        const double none = Snr(meter, {.precision = Precision::Fp24});
        const double half = Snr(meter, {.precision = Precision::Fp24, .bias = Bias::Half});
        EXPECT_NEAR(half - none, Decibels(0.18 / 0.32), 1);
        EXPECT_GT(Snr(meter, {.precision = Precision::Fp24, .bias = Bias::Mean}), none + 16);
    }
}

// Sums of 0.5 and -0.5 are short binary numbers that stay small; those of 0 and 1 outgrow a half's 11 bits.
TEST(PrecisionLaws, BlackAndWhiteLessHalfIsExact) {
    for (const uint32_t square : {1u, 7u, 16u}) {
        const Subject subject = Checkerboard({256, 250}, square, 0, 255);
        Meter meter(TestDevice(), subject);
        for (const Precision precision : {Precision::Fp16, Precision::Fp24, Precision::Fp32})
            for (const SATOrigin origin : {SATOrigin::Corner, SATOrigin::Center})
                EXPECT_EQ(meter.Measure({precision, Bias::Half, origin}).widths[0].rms, 0.0)
                    << square << Name(precision);
        EXPECT_LT(Snr(meter, {.precision = Precision::Fp16}), 40);
    }
}

// The last number below infinity is 65504, and 65520 already rounds to it: 256 x 256 texels reach that with a mean of
// 0.99976, which among 8-bit codes only 255 has; 257 x 256 texels of 254 do, too.
TEST(PrecisionLaws, WhitePicturesOverflowAHalf) {
    const auto overflows = [](const Subject& subject, Bias bias = Bias::None, SATOrigin origin = SATOrigin::Corner) {
        Meter meter(TestDevice(), subject, {1});
        const Measurement measured = meter.Measure({Precision::Fp16, bias, origin});
        EXPECT_EQ(measured.snrDb.has_value(), measured.widths[0].rms.has_value());
        return !measured.snrDb;
    };
    EXPECT_TRUE(overflows(Constant({256, 256}, 255)));
    EXPECT_FALSE(overflows(Constant({256, 256}, 254)));
    EXPECT_TRUE(overflows(Constant({257, 256}, 254)));
    EXPECT_FALSE(overflows(Constant({256, 256}, 255), Bias::Half));
    EXPECT_FALSE(overflows(Constant({256, 256}, 255), Bias::None, SATOrigin::Center));
    Meter meter(TestDevice(), Constant({256, 256}, 255));
    EXPECT_TRUE(meter.Measure({.precision = Precision::Fp24}).snrDb);
}

// The mean of a picture with a sun is far above its other texels: taking it off spoils all sums that the sun is not
// in. An origin in the centre costs them nothing.
TEST(PrecisionLaws, MeanOfAnHdrPictureHurtsItsDarkTexels) {
    const Extent2D extent{256, 256};
    Subject subject = Noise(extent, 8, 0, 30);
    for (uint32_t y = 232; y < 248; y++)
        for (uint32_t x = 232; x < 248; x++)
            subject.texels[256 * y + x] = glm::vec4(1000);
    subject = SubjectOf(extent, subject.texels, 0);
    Meter meter(TestDevice(), subject, {1});
    const auto errorBeforeTheSun = [&](const Case& setup) {
        const Texels read = meter.Identity(setup);
        double squares = 0;
        for (uint32_t y = 0; y < 231; y++)
            for (uint32_t x = 0; x < 231; x++)
                squares += std::pow(double(read[256 * y + x].x) - subject.texels[256 * y + x].x, 2);
        return std::sqrt(squares / (231.0 * 231.0));
    };
    const double none = errorBeforeTheSun({});
    EXPECT_GT(errorBeforeTheSun({.bias = Bias::Mean}), 30 * none);
    EXPECT_LT(errorBeforeTheSun({.origin = SATOrigin::Center}), none);
}

// Scheuermann 2005: precision errors are unbiased and average out over larger boxes. The four entries that are read
// have the same error whatever the width, so the error of a mean falls as 1 / area.
TEST(PrecisionLaws, ErrorsAreUnbiasedAndFallWithTheArea) {
    const Subject subject = Photograph("fruits.jpg");
    Meter meter(TestDevice(), subject);
    const Measurement measured = meter.Measure({.precision = Precision::Fp24});
    const double rms = *measured.widths[0].rms;
    for (const auto& [sizeTexels, widthRms] : measured.widths) {
        const double byArea = rms / (sizeTexels * sizeTexels);
        EXPECT_GT(*widthRms, byArea / 1.5) << sizeTexels;
        EXPECT_LT(*widthRms, byArea * 1.5) << sizeTexels;
    }
    const Texels read = meter.Identity({.precision = Precision::Fp24});
    double sum = 0;
    for (size_t i = 0; i < read.size(); i++)
        sum += double(read[i].x) - subject.texels[i].x;
    EXPECT_LT(std::abs(sum) / static_cast<double>(read.size()), 1e-3 * rms);
}

// Truncated sums are all too small, and more so the larger: narrow boxes do not notice, wide ones do.
TEST(PrecisionLaws, TruncatedErrorsDoNotAverageOut) {
    Meter meter(TestDevice(), Photograph("fruits.jpg"));
    const Measurement nearest = meter.Measure({.precision = Precision::Fp24, .origin = SATOrigin::Center});
    const Measurement truncated = meter.Measure({.precision = Precision::Fp24Truncated, .origin = SATOrigin::Center});
    EXPECT_LT(*truncated.widths.front().rms, *nearest.widths.front().rms);
    EXPECT_GT(*truncated.widths.back().rms, 2 * *nearest.widths.back().rms);
}

// A serial scan shares its error with its neighbours: the 1 x 1 box looks better, every wide one is worse, and so are
// the entries.
TEST(PrecisionLaws, TreeEntriesAreBetterThanSerialOnesThoughNarrowBoxesAreNot) {
    const Subject subject = Photograph("fruits.jpg", {150, 130, 200, 180});
    Meter meter(TestDevice(), subject);
    const Measurement tree = meter.Measure({});
    const Measurement serial = meter.Measure({.taps = 2, .builder = Builder::Lines});
    EXPECT_GT(*serial.snrDb, *tree.snrDb + 3);
    EXPECT_GT(*serial.widths.back().rms, 3 * *tree.widths.back().rms);
    const auto exact = reference::SummedAreaTable(ToDouble(subject.extent, subject.texels));
    const auto entryError = [&](const TableSetup& setup) {
        const Texels table = TableOf(subject, setup);
        double squares = 0;
        for (size_t i = 0; i < table.size(); i++)
            squares += std::pow(table[i].x - exact.texels[i].x, 2);
        return std::sqrt(squares / static_cast<double>(table.size()));
    };
    const double ratio = entryError({.taps = 2, .builder = Builder::Lines}) / entryError({});
    EXPECT_GT(ratio, 7);
    EXPECT_LT(ratio, 20);
}

// The frame and the border colour give the same boxes.
TEST(PrecisionLaws, FrameMeasuresAsTheBorderColour) {
    Meter meter(TestDevice(), Photograph("fruits.jpg", {60, 60, 190, 140}));
    for (const Bias bias : {Bias::None, Bias::Half, Bias::Mean}) {
        const Measurement border = meter.Measure({.bias = bias});
        const Measurement frame = meter.Measure({.bias = bias, .builder = Builder::Frame});
        EXPECT_EQ(border.snrDb, frame.snrDb);
        for (size_t i = 0; i < border.widths.size(); i++)
            EXPECT_EQ(border.widths[i].rms, frame.widths[i].rms);
    }
}

}  // namespace
}  // namespace boxcar
