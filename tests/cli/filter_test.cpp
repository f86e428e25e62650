// boxcar filter, from file to file, against the definition of its result in double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

// What an 8 or 16-bit file is to hold: `texel` filtered in light, as codes in [0, 1].
glm::dvec4 ReferenceCode(glm::dvec4 texel, int channels, bool srgb) {
    if (!srgb) return texel;
    const int alpha = channels % 2 == 0 ? channels - 1 : -1;
    for (int c = 0; c < channels; c++) {
        if (c == alpha) continue;
        if (alpha >= 0) texel[c] = texel[alpha] > 0 ? texel[c] / texel[alpha] : 0;
        texel[c] = ReferenceEncode(texel[c]);
    }
    return texel;
}

struct Case {
    std::string flags;
    double width, height;
    reference::Edge edge;
    bool srgb;
};
const Case kCases[] = {
    {"--width 5", 5, 5, reference::Edge::Clip, true},
    {"--width 4.5x9 --edge zero", 4.5, 9, reference::Edge::Zero, true},
    {"--width 3x1 --transfer raw --taps 16", 3, 1, reference::Edge::Clip, false},
    {"--width 200 --taps 2", 200, 200, reference::Edge::Clip, true},
};

class FilterOfChannels : public testing::TestWithParam<int> {};

// The nearest code to the exact value; where that lies in the middle of two, either.
TEST_P(FilterOfChannels, IntegerFilesMatchTheDefinition) {
    const Folder folder;
    for (const SampleType stored : {SampleType::Unorm8, SampleType::Unorm16}) {
        const Picture picture = RandomPicture(37, 23, static_cast<uint32_t>(GetParam()), stored);
        WritePicture(picture, folder.Path("in.png"), FileFormat::Png, stored);
        const double codes = stored == SampleType::Unorm8 ? 255 : 65535;
        const double slackCodes = 5e-6 * codes;
        for (const Case& test : kCases) {
            const Outcome outcome = folder.Run("filter in.png -o out.png " + test.flags);
            ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
            const Picture filtered = ReadPicture(folder.Path("out.png"));
            ASSERT_EQ(filtered.channels, picture.channels);
            ASSERT_EQ(filtered.stored, stored);
            const auto light = ReferenceLight(picture, test.srgb);
            for (int y = 0; y < 23; y++) {
                for (int x = 0; x < 37; x++) {
                    const glm::dvec4 expected =
                        ReferenceCode(reference::BoxMean(light, x + 0.5, y + 0.5, test.width, test.height, test.edge),
                                      GetParam(), test.srgb);
                    for (int c = 0; c < GetParam(); c++) {
                        const double actual = filtered.samples[(y * 37 + x) * GetParam() + c] * codes;
                        ASSERT_NEAR(actual, expected[c] * codes, 0.5 + slackCodes)
                            << test.flags << " at " << x << ", " << y << " channel " << c;
                    }
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(GreyToRgba, FilterOfChannels, testing::Values(1, 2, 3, 4));

TEST(Filter, FloatFilesAreFilteredAsTheyStand) {
    const Folder folder;
    Picture picture = RandomPicture(40, 30, 3, SampleType::Float32);
    for (float& sample : picture.samples)
        sample = 100 * sample - 20;
    WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    const auto light = ReferenceLight(picture, false);
    for (const char* out : {"out.pfm", "out.exr"}) {
        ASSERT_EQ(folder.Run(fmt::format("filter in.pfm -o {} --width 7x4", out)).exitCode, 0);
        const Picture filtered = ReadPicture(folder.Path(out));
        for (int y = 0; y < 30; y++)
            for (int x = 0; x < 40; x++) {
                const auto expected = reference::BoxMean(light, x + 0.5, y + 0.5, 7, 4, reference::Edge::Clip);
                for (int c = 0; c < 3; c++)
                    ASSERT_NEAR(filtered.samples[(y * 40 + x) * 3 + c], expected[c], 2e-3) << x << ", " << y;
            }
    }
}

// An 8-bit picture written as EXR holds linear light; as PNG again, with --transfer srgb, its codes.
TEST(Filter, FloatOutputsHoldLinearLightAndGoBackToTheSameCodes) {
    const Folder folder;
    const Picture picture = RandomPicture(16, 16, 3, SampleType::Unorm8);
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    ASSERT_EQ(folder.Run("filter in.png -o light.exr --width 1").exitCode, 0);
    const Picture light = ReadPicture(folder.Path("light.exr"));
    for (size_t i = 0; i < light.samples.size(); i++)
        ASSERT_NEAR(light.samples[i], ReferenceDecode(picture.samples[i]), 1e-7);
    ASSERT_EQ(folder.Run("filter light.exr -o back.png --width 1 --transfer srgb").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("back.png")).samples, picture.samples);
}

TEST(Filter, WidthOneReturnsAPhotographToTheLastBit) {
    const Folder folder;
    const Picture photograph = ReadPicture(BOXCAR_ASSETS "/building.jpg");
    for (const char* width : {"1", "0.3", "1x0.001"}) {
        ASSERT_EQ(
            folder.Run(fmt::format("filter " BOXCAR_ASSETS "/building.jpg -o out.png --width {}", width)).exitCode,
            0);
        EXPECT_EQ(ReadPicture(folder.Path("out.png")).samples, photograph.samples);
    }
}

TEST(Filter, OutputMayBeTheInput) {
    const Folder folder;
    WritePicture(RandomPicture(9, 9, 3, SampleType::Unorm8), folder.Path("a.png"), FileFormat::Png,
                 SampleType::Unorm8);
    ASSERT_EQ(folder.Run("filter a.png -o b.png --width 3").exitCode, 0);
    ASSERT_EQ(folder.Run("filter a.png -o a.png --width 3").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("a.png")).samples, ReadPicture(folder.Path("b.png")).samples);
    EXPECT_EQ(folder.Names(), std::vector<std::string>({"a.png", "b.png"}));
}

TEST(Filter, ReadsStandardInputAndWritesStandardOutput) {
    const Folder folder;
    WritePicture(RandomPicture(9, 9, 3, SampleType::Unorm8), folder.Path("a.png"), FileFormat::Png,
                 SampleType::Unorm8);
    ASSERT_EQ(folder.Run("filter a.png -o b.png --width 3").exitCode, 0);
    const Outcome outcome = folder.Run("filter - -o - --format png --width 3 < a.png > piped.png");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(ReadPicture(folder.Path("piped.png")).samples, ReadPicture(folder.Path("b.png")).samples);
    EXPECT_EQ(outcome.err, "");
}

TEST(Filter, ManyInputsGoIntoAFolderUnderTheirNamesAndOneThatFailsStopsNoOther) {
    const Folder folder;
    for (const char* name : {"a.png", "c.png"})
        WritePicture(RandomPicture(9, 9, 3, SampleType::Unorm8), folder.Path(name), FileFormat::Png,
                     SampleType::Unorm8);
    folder.WriteText("b.png", "no picture");
    const Outcome outcome = folder.Run("filter a.png b.png c.png -o new/ --width 3");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err,
              "boxcar: b.png: no picture that is known; PNG, JPEG, HDR, EXR or PFM is expected\n"
              "boxcar: 1 of 3 inputs failed\n");
    EXPECT_NO_THROW(ReadPicture(folder.Path("new/a.png")));
    EXPECT_NO_THROW(ReadPicture(folder.Path("new/c.png")));
    EXPECT_EQ(folder.Run("filter a.png c.png -o new --format exr --width 3").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("new/a.exr")).stored, SampleType::Float32);
}

TEST(Filter, JsonIsOneDocumentAndNothingElse) {
    const Folder folder;
    WritePicture(RandomPicture(100, 50, 3, SampleType::Unorm8), folder.Path("a.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Outcome outcome = folder.Run("filter a.png -o b.png --width 3 --json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const auto document = nlohmann::json::parse(outcome.out);
    const auto& result = document.at("results").at(0);
    EXPECT_EQ(result.at("input"), "a.png");
    EXPECT_EQ(result.at("width"), 100);
    // ceil(log4 100), ceil(log4 50), filter.
    EXPECT_EQ(result.at("passes").size(), 4u + 3 + 1);
    EXPECT_EQ(result.at("precision"), "u32");
    EXPECT_EQ(result.at("rounds"), 1);
    // The finest power of two of which a 3 x 3 box of white fits into 32 bits.
    EXPECT_EQ(result.at("step"), 0x1p-28);
    EXPECT_GE(result.at("device_bytes"), 100 * 50 * 64);
    EXPECT_FALSE(document.at("device").get<std::string>().empty());
}

TEST(Filter, JsonOfACopyNamesNoTable) {
    const Folder folder;
    WritePicture(RandomPicture(4, 4, 3, SampleType::Unorm8), folder.Path("a.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Outcome outcome = folder.Run("filter a.png -o b.png --width 1 --json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto document = nlohmann::json::parse(outcome.out);
    const auto& result = document.at("results").at(0);
    EXPECT_TRUE(result.at("precision").is_null());
    EXPECT_TRUE(result.at("step").is_null());
    EXPECT_EQ(result.at("table_bytes"), 0);
}

TEST(Filter, StatsNameDevicePassesTimesAndMemory) {
    const Folder folder;
    WritePicture(RandomPicture(100, 50, 3, SampleType::Unorm8), folder.Path("a.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Outcome outcome = folder.Run("filter a.png -o b.png --width 3 --stats");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const char* text :
         {"a.png -> b.png: 100 x 50", "device", "table x3", "table y2", "filter", " ms", "8 passes",
          "device memory 0.3 MiB, 0.2 MiB of it the u32 table's", "in steps of 3.73e-09"})
        EXPECT_NE(outcome.err.find(text), std::string::npos) << text << " is not in:\n" << outcome.err;
}

TEST(Filter, NanIsRefusedWithItsPlaceOrReplaced) {
    const Folder folder;
    Picture picture = RandomPicture(8, 4, 1, SampleType::Float32);
    picture.samples[2 * 8 + 5] = std::nanf("");
    picture.samples[3 * 8 + 1] = INFINITY;
    WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    const Outcome refused = folder.Run("filter in.pfm -o out.pfm --width 3");
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_EQ(refused.err,
              "boxcar: in.pfm: NaN or infinity at (5, 2), which would spread from there; --nan zero replaces "
              "it\n");
    EXPECT_EQ(folder.Names(), std::vector<std::string>({"in.pfm"}));

    ASSERT_EQ(folder.Run("filter in.pfm -o out.pfm --width 3 --nan zero").exitCode, 0);
    picture.samples[2 * 8 + 5] = picture.samples[3 * 8 + 1] = 0;
    WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    ASSERT_EQ(folder.Run("filter in.pfm -o expected.pfm --width 3").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("out.pfm")).samples, ReadPicture(folder.Path("expected.pfm")).samples);
}

TEST(Filter, BitsChoosesThePngsDepth) {
    const Folder folder;
    WritePicture(RandomPicture(4, 4, 3, SampleType::Unorm8), folder.Path("a.png"), FileFormat::Png,
                 SampleType::Unorm8);
    ASSERT_EQ(folder.Run("filter a.png -o b.png --width 3 --bits 16").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("b.png")).stored, SampleType::Unorm16);
}

}  // namespace
}  // namespace boxcar
