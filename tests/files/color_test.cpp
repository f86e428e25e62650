#include "samples/files/color.h"

#include <cmath>
#include <limits>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

TEST(ColorTest, TheCurveHasTheValuesOfTheStandard) {
    EXPECT_EQ(SrgbToLinear(0.0), 0.0);
    EXPECT_EQ(SrgbToLinear(1.0), 1.0);
    EXPECT_EQ(LinearToSrgb(0.0), 0.0);
    EXPECT_NEAR(LinearToSrgb(1.0), 1.0, 1e-15);
    // To 16 digits, by arithmetic of 40 digits.
    EXPECT_NEAR(SrgbToLinear(0.5), 0.2140411404822325, 1e-15);
    EXPECT_NEAR(SrgbToLinear(188.0 / 255.0), 0.5028864580325687, 1e-15);
    EXPECT_NEAR(LinearToSrgb(0.5), 0.7353569830524495, 1e-15);
    EXPECT_NEAR(LinearToSrgb(0.18), 0.4613561295004416, 1e-15);
}

TEST(ColorTest, ThePiecesMeetWhereTheStandardPutsTheJoint) {
    EXPECT_EQ(SrgbToLinear(0.04045), 0.04045 / 12.92);
    EXPECT_EQ(LinearToSrgb(0.0031308), 0.0031308 * 12.92);
    // The standard's constants are rounded: the pieces miss each other by 3e-8 and no more.
    EXPECT_NEAR(SrgbToLinear(std::nextafter(0.04045, 1.0)), SrgbToLinear(0.04045), 3e-8);
    EXPECT_NEAR(LinearToSrgb(std::nextafter(0.0031308, 1.0)), LinearToSrgb(0.0031308), 3e-8);
    EXPECT_NE(SrgbToLinear(std::nextafter(0.04045, 1.0)), std::nextafter(0.04045, 1.0) / 12.92);
    EXPECT_NE(LinearToSrgb(std::nextafter(0.0031308, 1.0)), std::nextafter(0.0031308, 1.0) * 12.92);
}

TEST(ColorTest, GoesOnBelow0AndAbove1) {
    EXPECT_EQ(SrgbToLinear(-0.5), -0.5 / 12.92);
    EXPECT_EQ(LinearToSrgb(-0.5), -0.5 * 12.92);
    EXPECT_NEAR(LinearToSrgb(SrgbToLinear(4.0)), 4.0, 1e-14);
}

TEST(ColorTest, EveryCodeComesBackAndEverySampleIsTheDoubleRoundedOnce) {
    for (const uint32_t largest : {255u, 65535u}) {
        Picture picture{largest + 1, 1, 1, SampleType::Float32, {}};
        for (uint32_t code = 0; code <= largest; ++code)
            picture.samples.push_back(static_cast<float>(code) / static_cast<float>(largest));
        const std::vector<float> codes = picture.samples;
        DecodeSrgb(picture);
        for (uint32_t code = 0; code <= largest; ++code) {
            const double encoded = codes[code];
            const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
            ASSERT_EQ(picture.samples[code], static_cast<float>(linear)) << code;
        }
        EncodeSrgb(picture);
        for (uint32_t code = 0; code <= largest; ++code)
            ASSERT_EQ(std::lround(picture.samples[code] * static_cast<float>(largest)), static_cast<long>(code));
    }
}

TEST(ColorTest, AlphaIsNeverPutThroughTheCurve) {
    for (const uint32_t channels : {1u, 2u, 3u, 4u}) {
        Picture picture{1, 1, channels, SampleType::Float32, std::vector<float>(channels, 0.5f)};
        DecodeSrgb(picture);
        for (uint32_t c = 0; c < channels; ++c) {
            const bool isAlpha = channels % 2 == 0 && c == channels - 1;
            EXPECT_EQ(picture.samples[c], isAlpha ? 0.5f : static_cast<float>(SrgbToLinear(0.5)));
        }
        EncodeSrgb(picture);
        for (const float sample : picture.samples)
            EXPECT_NEAR(sample, 0.5f, 1e-7f);
    }
}

TEST(ColorTest, PremultiplyingIsUndone) {
    Picture picture{2, 2, 4, SampleType::Float32, {}};
    picture.samples = {1, 0.5f, 2, 0.25f, 8, -4, 0, 1, 3, 2, 1, 0, 4, 4, 4, -0.5f};
    Premultiply(picture);
    EXPECT_EQ(picture.samples,
              (std::vector<float>{0.25f, 0.125f, 0.5f, 0.25f, 8, -4, 0, 1, 0, 0, 0, 0, -2, -2, -2, -0.5f}));
    Unpremultiply(picture);
    EXPECT_EQ(picture.samples, (std::vector<float>{1, 0.5f, 2, 0.25f, 8, -4, 0, 1, 0, 0, 0, 0, 0, 0, 0, -0.5f}));

    Picture grey{1, 1, 2, SampleType::Float32, {0.5f, 0.5f}};
    Premultiply(grey);
    EXPECT_EQ(grey.samples, (std::vector<float>{0.25f, 0.5f}));
    Picture opaque{1, 1, 3, SampleType::Float32, {1, 2, 3}};
    Premultiply(opaque);
    Unpremultiply(opaque);
    EXPECT_EQ(opaque.samples, (std::vector<float>{1, 2, 3}));
}

TEST(ColorTest, TheFirstTexelThatIsNotFiniteIsFound) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        Picture picture{12, 19, 3, SampleType::Float32, std::vector<float>(12 * 19 * 3, 1e38f)};
        EXPECT_FALSE(FirstNotFinite(picture));
        picture.samples[(12 * 18 + 11) * 3 + 2] = bad;
        ASSERT_TRUE(FirstNotFinite(picture));
        EXPECT_EQ(FirstNotFinite(picture)->x, 11u);
        EXPECT_EQ(FirstNotFinite(picture)->y, 18u);
        picture.samples[(12 * 5 + 7) * 3] = bad;
        EXPECT_EQ(FirstNotFinite(picture)->x, 7u);
        EXPECT_EQ(FirstNotFinite(picture)->y, 5u);
        ZeroNotFinite(picture);
        EXPECT_FALSE(FirstNotFinite(picture));
        EXPECT_EQ(picture.samples[(12 * 5 + 7) * 3], 0.0f);
        EXPECT_EQ(picture.samples[(12 * 5 + 7) * 3 + 1], 1e38f);
    }
}

}  // namespace
}  // namespace boxcar::test
