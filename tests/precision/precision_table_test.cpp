// The laboratory's tables on the device, against their definition, the product's table and each other.
#include "samples/cli/precision/precision_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>

#include "hlsl/constants/precision_constants.h"
#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "precision_shaders.h"
#include "runtime/passes/summed_area_table.h"
#include "test_support_shaders.h"
#include "tests/precision/subjects.h"
#include "tests/reference/precision.h"
#include "tests/support/offsets.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtents[] = {{1, 1}, {1, 6}, {6, 1}, {12, 19}, {49, 2}, {100, 75}, {256, 130}};
constexpr uint32_t kTaps[] = {2, 4, 8, 16};

bool SameBits(const Texels& a, const Texels& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec4)) == 0;
}

reference::DoubleImage AsDouble(const Subject& subject) {
    return ToDouble(subject.extent, subject.texels);
}

std::string Sizes(Extent2D extent) {
    return fmt::format("{} x {}", extent.widthTexels, extent.heightTexels);
}

TEST(PrecisionTable, IsTheProductsInFloat32) {
    for (const Extent2D extent : kExtents) {
        const Subject subject = SubjectOf(extent, RandomValues(extent, 1));
        for (const uint32_t taps : kTaps) {
            for (const glm::vec4 bias : {glm::vec4(0), glm::vec4(0.3f, 0.5f, 0.7f, 1)}) {
                SummedAreaTable product(TestDevice(), {.extent = extent, .taps = taps});
                const Image biasTexel = Upload({1, 1}, Texels(1, bias));
                const Texels expected =
                    RunOnDevice(extent, subject.texels, [&](CommandList& c, const Image& source) -> const Image& {
                        return *product.Record(c, source, &biasTexel).low;
                    });
                EXPECT_TRUE(SameBits(TableOf(subject, {.bias = bias, .taps = taps}), expected))
                    << Sizes(extent) << ", " << taps << " taps";
            }
        }
    }
}

TEST(PrecisionTable, EveryTapsGivesTheSameBitsWhereEveryAdditionIsRoundedAlike) {
    for (const Extent2D extent : kExtents) {
        const Subject subject = Noise(extent, 2);
        for (const Precision precision :
             {Precision::Fp24, Precision::Fp24Truncated, Precision::Fp32, Precision::U32}) {
            for (const SATOrigin origin : {SATOrigin::Corner, SATOrigin::Center}) {
                const TableSetup setup{.precision = precision, .origin = origin, .taps = 2};
                const Texels twoTaps = TableOf(subject, setup);
                for (const uint32_t taps : kTaps) {
                    TableSetup other = setup;
                    other.taps = taps;
                    EXPECT_TRUE(SameBits(TableOf(subject, other), twoTaps))
                        << Sizes(extent) << ", " << taps << " taps, " << Name(precision) << ", " << Name(origin);
                }
            }
        }
    }
}

// Scheuermann 2005 offers the two boundary set-ups as equals. The frame costs two rows and columns and moves every
// entry by a texel; the entries themselves are the same.
TEST(PrecisionTable, FrameHoldsTheSameEntriesOneTexelOn) {
    for (const Extent2D extent : kExtents) {
        const Subject subject = SubjectOf(extent, RandomValues(extent, 3));
        for (const glm::vec4 bias : {glm::vec4(0), glm::vec4(0.5f)}) {
            const Texels plain = TableOf(subject, {.bias = bias});
            const Texels framed = TableOf(subject, {.bias = bias, .builder = Builder::Frame});
            const uint32_t width = extent.widthTexels + 2;
            ASSERT_EQ(framed.size(), width * size_t{extent.heightTexels + 2});
            Texels inside;
            for (uint32_t y = 1; y <= extent.heightTexels; y++)
                inside.insert(inside.end(), framed.begin() + y * width + 1, framed.begin() + (y + 1) * width - 1);
            EXPECT_TRUE(SameBits(inside, plain)) << Sizes(extent);
        }
    }
}

// Green 2003: every column from the one before, then every row.
TEST(PrecisionTable, LinesAreASerialScan) {
    for (const Extent2D extent : kExtents) {
        const Subject subject = SubjectOf(extent, RandomValues(extent, 4));
        const reference::Arithmetic arithmetic = reference::kArithmeticFp32;
        const auto expected = reference::ScanOutwards(AsDouble(subject), 0, 0, [&](std::vector<double> line) {
            return reference::SerialScan(std::move(line), arithmetic);
        });
        const Texels lines = TableOf(subject, {.taps = 2, .builder = Builder::Lines});
        for (size_t i = 0; i < lines.size(); i++)
            ASSERT_EQ(glm::dvec4(lines[i]), expected.texels[i]) << Sizes(extent) << ", entry " << i;
    }
}

// The rectangle is pixels x .. x + a - 1; as printed, without its minus signs and a pixel too far, it is not.
TEST(PrecisionTable, GreensLookupIsTheMeanOfTheRectangle) {
    const Extent2D extent{4, 4};
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/precision_green.ps")});
    const Image means(TestDevice(), {extent, Format::RGBA32F, "means"});
    for (const Texels& source : {Texels(16, glm::vec4(1)), RandomCodes(extent, 5)}) {
        const Texels table = TableOf(SubjectOf(extent, source, 0), {.taps = 2, .builder = Builder::Lines});
        for (int a = 1; a <= 4; a++) {
            for (int b = 1; b <= 4; b++) {
                const PrecisionBoxConstants constants{int2(4), int2(0), float4(0), int2(a, b), int2(0)};
                const Texels result =
                    RunOnDevice(extent, table, [&](CommandList& commands, const Image& image) -> const Image& {
                        commands.Draw({.name = "Green's lookup",
                                       .pipeline = pipeline,
                                       .reads = {{"table", &image}},
                                       .writes = {&means},
                                       .constants = ConstantBytes(constants)});
                        return means;
                    });
                const auto image = ToDouble(extent, source);
                for (int y = 0; y + b <= 4; y++)
                    for (int x = 0; x + a <= 4; x++)
                        for (int c = 0; c < 4; c++)
                            EXPECT_FLOAT_EQ(result[4 * y + x][c],
                                            static_cast<float>(reference::BoxMean(image, x + a / 2.0, y + b / 2.0, a,
                                                                                  b, reference::Edge::Clip)[c]))
                                << x << ", " << y << ": " << a << " x " << b;
            }
        }
    }
}

void ExpectNoneWrong(const Subject& subject, const Case& setup) {
    Meter meter(TestDevice(), subject);
    const Measurement measured = meter.Measure(setup);
    for (const Measurement::Width& width : measured.widths)
        EXPECT_EQ(width.rms, 0.0) << "width " << width.sizeTexels;
    ASSERT_TRUE(measured.snrDb);
    EXPECT_TRUE(std::isinf(*measured.snrDb));
}

TEST(PrecisionTable, WholeCodesAreExact) {
    for (const Extent2D extent : kExtents)
        for (const Builder builder : {Builder::Raster, Builder::Blocks})
            for (const uint32_t taps : kTaps)
                ExpectNoneWrong(Noise(extent, 6), {.precision = Precision::U32, .taps = taps, .builder = builder});
}

// Every sum is the largest that there can be: a block holds 256 x 255 = 65,280, which fits 16 bits.
TEST(PrecisionTable, BlocksHoldWhite) {
    ExpectNoneWrong(Constant({200, 333}, 255), {.precision = Precision::U32, .builder = Builder::Blocks});
}

// 300 x 300 codes of 65,535 sum to more than 2^32; boxes of 129 x 129 do not.
TEST(PrecisionTable, SumsThatWrapGiveTheRightDifferences) {
    const Extent2D extent{300, 300};
    ExpectNoneWrong(SubjectOf(extent, Texels(extent.Texels(), glm::vec4(1)), 65535), {.precision = Precision::U32});
}

struct Emulated {
    Precision precision;
    reference::Arithmetic arithmetic;
};

// Pictures of three kinds, sizes also not powers of two: the device's SNR is the definition's.
TEST(PrecisionTable, SnrIsThatOfTheDefinition) {
    const Emulated kinds[] = {{Precision::Fp16, reference::kArithmeticFp16},
                              {Precision::Fp24, reference::kArithmeticFp24},
                              {Precision::Fp24Truncated, reference::kArithmeticFp24Truncated},
                              {Precision::Fp32, reference::kArithmeticFp32}};
    const Subject subjects[] = {Photograph("fruits.jpg", {200, 150, 90, 61}), Checkerboard({70, 45}, 7, 20, 230),
                                Noise({64, 50}, 7)};
    for (const Subject& subject : subjects) {
        Meter meter(TestDevice(), subject, {1});
        const auto image = AsDouble(subject);
        for (const auto& [precision, arithmetic] : kinds) {
            for (const Bias bias : {Bias::None, Bias::Half, Bias::Mean}) {
                const glm::vec4 taken[] = {glm::vec4(0), glm::vec4(0.5f), meter.Mean()};
                for (const SATOrigin origin : {SATOrigin::Corner, SATOrigin::Center}) {
                    for (const uint32_t taps : {2u, 16u}) {
                        const auto measured = meter.Measure({precision, bias, origin, taps}).snrDb;
                        const double expected = reference::IdentitySnrDb(
                            image,
                            reference::BuildRounded(image, arithmetic, taken[static_cast<size_t>(bias)],
                                                    origin == SATOrigin::Center, taps),
                            3);
                        ASSERT_TRUE(measured);
                        EXPECT_NEAR(*measured, expected, 0.1)
                            << Sizes(subject.extent) << ", " << Name(precision) << ", bias " << Name(bias) << ", "
                            << Name(origin) << ", " << taps << " taps";
                    }
                }
            }
        }
    }
}

TEST(PrecisionConstants, OffsetsInCppEqualThoseInTheShaders) {
    EXPECT_EQ(OffsetsIn(precision_shaders::Find("shaders/precision_texel.ps.PRECISION=fp32")),
              Offsets({OFFSET(PrecisionTexelConstants, bias), OFFSET(PrecisionTexelConstants, extentTexels),
                       OFFSET(PrecisionTexelConstants, frameTexels), OFFSET(PrecisionTexelConstants, scale)}));
    EXPECT_EQ(OffsetsIn(precision_shaders::Find("shaders/precision_pass.ps.PRECISION=fp32.TAPS=2")),
              Offsets({OFFSET(SATPassConstants, strideUv), OFFSET(SATPassConstants, strideTexels),
                       OFFSET(SATPassConstants, originTexels)}));
    EXPECT_EQ(OffsetsIn(precision_shaders::Find("shaders/precision_line.ps.PRECISION=fp32")),
              Offsets({OFFSET(PrecisionLineConstants, stepTexels)}));
    EXPECT_EQ(OffsetsIn(precision_shaders::Find("shaders/precision_box.ps.PRECISION=fp32")),
              Offsets({OFFSET(PrecisionBoxConstants, extentTexels), OFFSET(PrecisionBoxConstants, middleTexels),
                       OFFSET(PrecisionBoxConstants, bias), OFFSET(PrecisionBoxConstants, sizeTexels),
                       OFFSET(PrecisionBoxConstants, frameTexels)}));
}

}  // namespace
}  // namespace boxcar
