// The laboratory's numbers, on the device, against their definition.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "hlsl/constants/precision_constants.h"
#include "passes_shaders.h"
#include "test_support_shaders.h"
#include "tests/reference/precision.h"
#include "tests/support/device_image.h"

namespace boxcar {
namespace {

Texels RoundedOnDevice(const std::vector<float>& values) {
    const Extent2D extent{static_cast<uint32_t>(values.size()), 1};
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/precision_round.ps")});
    const Image rounded(TestDevice(), {extent, Format::RGBA32F, "rounded"});
    return RunOnDevice(
        extent, Texels(values.begin(), values.end()),
        [&](CommandList& commands, const Image& source) -> const Image& {
            commands.Draw(
                {.name = "round", .pipeline = pipeline, .reads = {{"source", &source}}, .writes = {&rounded}});
            return rounded;
        });
}

void ExpectAsDefined(const std::vector<float>& values) {
    const reference::NumberFormat formats[] = {reference::kHalf, reference::kAti24, reference::kAti24Truncated};
    const char* names[] = {"half", "24 bits", "24 bits truncated"};
    const Texels rounded = RoundedOnDevice(values);
    for (size_t i = 0; i < values.size(); i++) {
        for (int f = 0; f < 3; f++) {
            const auto expected = static_cast<float>(reference::RoundTo(formats[f], values[i]));
            if (std::isnan(expected)) {
                EXPECT_TRUE(std::isnan(rounded[i][f])) << names[f];
            } else {
                EXPECT_EQ(std::bit_cast<uint32_t>(rounded[i][f]), std::bit_cast<uint32_t>(expected))
                    << names[f] << " of " << std::hexfloat << values[i] << " is " << rounded[i][f] << ", not "
                    << expected;
            }
        }
    }
}

TEST(PrecisionRound, TiesGoToEvenAndCarriesRaiseTheExponent) {
    ExpectAsDefined({1 + 0x1p-17f, 1 + 0x3p-17f, 1 + 0x1p-17f + 0x1p-23f, 1 + 0x3p-17f - 0x1p-23f, 1 + 0x1p-11f,
                     1 + 0x3p-11f, 1 + 0x1p-11f + 0x1p-23f, 0x1.fffffep0f, 0x1.fffep0f, 0x1.ffep3f, -1 - 0x1p-17f,
                     -1 - 0x3p-17f, -0x1.fffffep5f, 255, 65503, 12345.678f});
}

TEST(PrecisionRound, LargestValueInfinityAndNan) {
    const float infinity = std::numeric_limits<float>::infinity();
    ExpectAsDefined({65504, 65519.99f, 65520, 65536, -65520, 0x1.fffep63f, 0x1.ffff7p63f, 0x1.ffffp63f,
                     0x1.fffffep63f, 0x1p64f, -0x1p64f, 0x1.fffffep127f, infinity, -infinity,
                     std::numeric_limits<float>::quiet_NaN()});
}

TEST(PrecisionRound, SmallValues) {
    ExpectAsDefined({0.0f, -0.0f, 0x1p-14f, 0x1.ffcp-15f, 0x1.fffffep-15f, 0x1p-24f, 0x1.8p-24f, 0x1.4p-23f,
                     0x1.cp-23f, 0x1p-25f, 0x1.000002p-25f, 0x1p-26f, -0x1.000002p-25f, 0x1p-62f, 0x1.fffffep-63f,
                     0x1.fffep-63f, -0x1p-63f, 0x1p-126f, 0x1p-149f});
}

TEST(PrecisionRound, AnyBits) {
    std::mt19937 random(1);
    std::vector<float> values;
    for (int i = 0; i < 8192; i++) {
        // Every second one near the range of a half.
        const auto bits = static_cast<uint32_t>(random());
        const float value = std::bit_cast<float>(bits);
        values.push_back(i % 2 ? value
                               : std::ldexp(std::bit_cast<float>((bits & 0x807fffff) | 0x3f800000),
                                            static_cast<int>(random() % 45) - 27));
    }
    ExpectAsDefined(values);
}

}  // namespace
}  // namespace boxcar
