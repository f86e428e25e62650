// What pictures say beside their samples: applied, kept, or told in a line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

// The header of a profile without tags, and what follows it.
std::vector<uint8_t> Profile() {
    std::vector<uint8_t> profile(300);
    const auto put = [&](size_t at, const std::string& text) {
        std::ranges::copy(text, profile.begin() + static_cast<ptrdiff_t>(at));
    };
    profile[2] = 300 >> 8;
    profile[3] = 300 & 255;
    put(8, "\2");
    put(12, "mntrRGB XYZ ");
    put(36, "acsp");
    put(70, "\xf6\xd6");  // D50 as X Y Z of 16.16 bits
    put(73, "\1");
    put(78, "\xd3\x2d");
    for (size_t i = 132; i < profile.size(); i++)
        profile[i] = static_cast<uint8_t>(i);
    return profile;
}

const Primaries kP3 = {0.68f, 0.32f, 0.265f, 0.69f, 0.15f, 0.06f, 0.3127f, 0.329f};

// Codes that are light to the power of the file's gamma are averaged as light, and come out as sRGB.
TEST(ColorSpaceOfFiles, GammaOfAPngIsTakenOffBeforeTheFilter) {
    const Folder folder;
    for (const SampleType stored : {SampleType::Unorm8, SampleType::Unorm16}) {
        for (const double gamma : {1.0, 0.5, 0.8}) {
            Picture picture = RandomPicture(8, 4, 4, stored);
            for (size_t i = 3; i < picture.samples.size(); i += 4)
                picture.samples[i] = 1;
            picture.colorSpace.gamma = gamma;
            WritePicture(picture, folder.Path("in.png"), FileFormat::Png, stored);
            for (const char* precision : {"", " --precision u64"}) {
                const Outcome outcome =
                    folder.Run(fmt::format("filter in.png -o out.png --width 3x1 --edge mirror{}", precision));
                ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
                if (precision[0] == '\0') {
                    EXPECT_EQ(outcome.err, "");
                }
                const Picture out = ReadPicture(folder.Path("out.png"));
                EXPECT_EQ(out.colorSpace.gamma, 0);
                const auto lightAt = [&](int x, int y, int c) {
                    const int column = x < 0 ? 0 : x > 7 ? 7 : x;
                    return std::pow(picture.samples[static_cast<size_t>((y * 8 + column) * 4 + c)], 1 / gamma);
                };
                for (int y = 0; y < 4; y++)
                    for (int x = 0; x < 8; x++)
                        for (int c = 0; c < 3; c++) {
                            const double mean = (lightAt(x - 1, y, c) + lightAt(x, y, c) + lightAt(x + 1, y, c)) / 3;
                            const double step = stored == SampleType::Unorm8 ? 1 / 255.0 : 1 / 65535.0;
                            // Codes asked for by name are 16 bits of light: 13 codes of 16 bits apart where the sRGB
                            // curve is steepest.
                            const double named = precision[0] == '\0' ? 0 : 7.0 / 65535;
                            ASSERT_NEAR(out.samples[static_cast<size_t>((y * 8 + x) * 4 + c)], ReferenceEncode(mean),
                                        0.51 * step + named)
                                << x << ", " << y;
                        }
            }
        }
    }
}

// --transfer raw takes codes as they stand, so they mean afterwards what they meant before.
TEST(ColorSpaceOfFiles, RawKeepsCodesAndTheirGamma) {
    const Folder folder;
    Picture picture = RandomPicture(8, 4, 1, SampleType::Unorm8);
    picture.colorSpace.gamma = 1;
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    ASSERT_EQ(folder.Run("filter in.png -o out.png --width 1 --transfer raw").exitCode, 0);
    const Picture out = ReadPicture(folder.Path("out.png"));
    EXPECT_EQ(out.samples, picture.samples);
    EXPECT_EQ(out.colorSpace.gamma, 1);
}

TEST(ColorSpaceOfFiles, TheProfileGoesAlong) {
    const Folder folder;
    Picture picture = RandomPicture(8, 8, 3, SampleType::Unorm8);
    picture.colorSpace.iccProfile = Profile();
    WritePicture(picture, folder.Path("in.jpg"), FileFormat::Jpeg, SampleType::Unorm8);
    WritePicture(RandomPicture(8, 8, 1, SampleType::Unorm8), folder.Path("depth.png"), FileFormat::Png,
                 SampleType::Unorm8);
    for (const char* command : {"filter in.jpg --width 3", "resize in.jpg --size 5x3",
                                "dof in.jpg --depth depth.png --focus 0.5 --aperture 4"}) {
        for (const char* out : {"out.jpg", "out.png"}) {
            const Outcome outcome = folder.Run(fmt::format("{} -o {}", command, out));
            ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
            EXPECT_EQ(outcome.err, "") << command;
            EXPECT_EQ(ReadPicture(folder.Path(out)).colorSpace.iccProfile, Profile());
        }
        const Outcome outcome = folder.Run(fmt::format("{} -o out.exr", command));
        EXPECT_EQ(outcome.exitCode, 0);
        EXPECT_EQ(
            outcome.err,
            "boxcar: out.exr: EXR cannot hold the input's ICC profile: its colors will be taken for linear light "
            "of sRGB's primaries\n");
    }
}

TEST(ColorSpaceOfFiles, PrimariesGoAlong) {
    const Folder folder;
    Picture picture = RandomPicture(8, 8, 3, SampleType::Float32);
    picture.colorSpace.primaries = kP3;
    WritePicture(picture, folder.Path("in.exr"), FileFormat::Exr, SampleType::Float32);
    for (const char* out : {"out.exr", "out.png"}) {
        const Outcome outcome = folder.Run(fmt::format("filter in.exr --width 3 -o {}", out));
        ASSERT_EQ(outcome.exitCode, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(ReadPicture(folder.Path(out)).colorSpace.primaries, kP3);
    }
    const Outcome outcome = folder.Run("filter in.exr --width 3 -o - --format jpg > out.jpg");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err,
              "boxcar: standard output: JPEG cannot hold the input's primaries: its colors will be taken for sRGB\n");
}

TEST(ColorSpaceOfFiles, NotesAreALineEach) {
    const Folder folder;
    folder.WriteText("in.hdr", "#?RADIANCE\nEXPOSURE=4\nGAMMA=2\n\n-Y 1 +X 1\nabcd");
    Outcome outcome = folder.Run("filter in.hdr --width 3 -o out.exr");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err,
              "boxcar: in.hdr: its GAMMA=2 is not used: values are as the file holds them\n"
              "boxcar: in.hdr: its EXPOSURE of 4 is not divided out: values are as the file holds them\n");
    outcome = folder.Run("filter - --width 3 -o out.exr < in.hdr");
    EXPECT_TRUE(outcome.err.starts_with("boxcar: standard input: its GAMMA=2 is")) << outcome.err;

    Picture environment = RandomPicture(8, 4, 3, SampleType::Float32);
    environment.colorSpace.primaries = kP3;
    WritePicture(environment, folder.Path("env.exr"), FileFormat::Exr, SampleType::Float32);
    outcome = folder.Run("render glossy-environment --env env.exr --size 16x16 -o out.png");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "boxcar: env.exr: its primaries are not used: its colors are taken for sRGB's\n");
    outcome = folder.Run("sweep glossy-environment --env env.exr --size 16x16 --set face=32,64,128 -o out.png");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "boxcar: env.exr: its primaries are not used: its colors are taken for sRGB's\n");
}

}  // namespace
}  // namespace boxcar
