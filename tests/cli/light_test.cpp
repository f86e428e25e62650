// Light and alpha from one kind of file to another: integers hold sRGB codes and straight alpha, floats linear light
// and colors times alpha.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

struct Kind {
    const char* ending;
    FileFormat format;
    SampleType sampleType;
};
constexpr Kind kPng8 = {"png", FileFormat::Png, SampleType::Unorm8};
constexpr Kind kPng16 = {"png", FileFormat::Png, SampleType::Unorm16};
constexpr Kind kExr = {"exr", FileFormat::Exr, SampleType::Float32};
constexpr Kind kPfm = {"pfm", FileFormat::Pfm, SampleType::Float32};

// A picture whose samples may all be exact in the file, and whose colors are 0 where alpha is.
Picture PictureFor(const Kind& kind, uint32_t channels) {
    Picture picture = RandomPicture(
        24, 10, channels, kind.sampleType == SampleType::Unorm16 ? SampleType::Unorm16 : SampleType::Unorm8);
    picture.stored = kind.sampleType;
    for (size_t i = 0; channels % 2 == 0 && i < picture.samples.size(); i += channels) {
        float& alpha = picture.samples[i + channels - 1];
        if (i / channels % 7 == 0) alpha = 0;
        for (size_t c = 0; c + 1 < channels; c++) {
            if (alpha == 0) picture.samples[i + c] = 0;
            if (kind.sampleType == SampleType::Float32) picture.samples[i + c] *= alpha;
        }
    }
    return picture;
}

// What a sample of `from` is as light, colors times alpha.
double LightOf(const Picture& picture, size_t i) {
    const size_t channels = picture.channels, channel = i % channels;
    const bool isAlpha = channels % 2 == 0 && channel + 1 == channels;
    if (picture.stored == SampleType::Float32 || isAlpha) return picture.samples[i];
    const double alpha = channels % 2 == 0 ? picture.samples[i - channel + channels - 1] : 1;
    return ReferenceDecode(picture.samples[i]) * alpha;
}

// Each command that only passes light on, from every kind to every other: the light is the same, up to the rounding
// of the file that is written.
TEST(LightOfFiles, IsTheSameInEveryKindOfFile) {
    const Folder folder;
    for (const Kind& from : {kPng8, kPng16, kExr, kPfm}) {
        for (const uint32_t channels : {1u, 2u, 3u, 4u}) {
            if (channels % 2 == 0 && from.format == FileFormat::Pfm) continue;
            const Picture picture = PictureFor(from, channels);
            const std::string in = fmt::format("in.{}", from.ending);
            WritePicture(picture, folder.Path(in), from.format, from.sampleType);
            for (const Kind& to : {kPng8, kPng16, kExr, kPfm}) {
                if (channels % 2 == 0 && to.format == FileFormat::Pfm) continue;
                for (const char* command : {"filter --width 1", "resize --scale 1 --filter nearest"}) {
                    const bool isFilter = command[0] == 'f';
                    if (to.sampleType == SampleType::Unorm16 && from.sampleType != SampleType::Unorm16 && !isFilter)
                        continue;
                    const std::string bits =
                        isFilter && to.format == FileFormat::Png
                            ? fmt::format(" --bits {}", to.sampleType == SampleType::Unorm8 ? 8 : 16)
                            : "";
                    if (!isFilter && to.sampleType == SampleType::Unorm8 && from.sampleType == SampleType::Unorm16)
                        continue;
                    const std::string out = fmt::format("out.{}", to.ending);
                    ASSERT_EQ(folder.Run(fmt::format("{} {} -o {}{}", command, in, out, bits)).exitCode, 0)
                        << command;
                    const Picture result = ReadPicture(folder.Path(out));
                    ASSERT_EQ(result.stored, to.sampleType);
                    ASSERT_EQ(result.samples.size(), picture.samples.size());
                    for (size_t i = 0; i < picture.samples.size(); i++) {
                        const size_t channel = i % channels;
                        const bool hasAlpha = channels % 2 == 0, isAlpha = hasAlpha && channel + 1 == channels;
                        const double light = LightOf(picture, i);
                        const double alpha = hasAlpha ? LightOf(picture, i - channel + channels - 1) : 1;
                        double expected = light;
                        if (to.sampleType != SampleType::Float32 && !isAlpha)
                            expected = alpha > 0 ? ReferenceEncode(light / alpha) : 0;
                        const double step = to.sampleType == SampleType::Unorm8    ? 0.501 / 255
                                            : to.sampleType == SampleType::Unorm16 ? 0.51 / 65535
                                                                                   : 1e-7;
                        ASSERT_NEAR(result.samples[i], std::clamp(expected, 0.0, 1.0), step)
                            << command << ", " << in << " to " << out << ", " << channels << " channels, sample "
                            << i;
                    }
                }
            }
        }
    }
}

// There and back again nothing is lost, for what a file of either kind can hold.
TEST(LightOfFiles, IntegersThroughFloatsAndBackAreTheIdentity) {
    const Folder folder;
    for (const Kind& from : {kPng8, kPng16}) {
        for (const uint32_t channels : {1u, 2u, 3u, 4u}) {
            const Picture picture = PictureFor(from, channels);
            WritePicture(picture, folder.Path("in.png"), from.format, from.sampleType);
            for (const char* through : {"through.exr", "through.pfm"}) {
                if (channels % 2 == 0 && through == std::string("through.pfm")) continue;
                ASSERT_EQ(folder.Run(fmt::format("filter in.png -o {} --width 1", through)).exitCode, 0);
                ASSERT_EQ(folder
                              .Run(fmt::format("filter {} -o back.png --width 1 --bits {}", through,
                                               from.sampleType == SampleType::Unorm8 ? 8 : 16))
                              .exitCode,
                          0);
                const Picture back = ReadPicture(folder.Path("back.png"));
                EXPECT_EQ(back.samples, picture.samples) << through << ", " << channels << " channels";
            }
        }
    }
}

TEST(LightOfFiles, FloatsBecomeCodesOfTheirLight) {
    const Folder folder;
    const Picture half{1, 1, 1, SampleType::Float32, {0.5f}},
        glass{1, 1, 4, SampleType::Float32, {0.1f, 0.2f, 0.4f, 0.5f}};
    WritePicture(half, folder.Path("half.exr"), FileFormat::Exr, SampleType::Float32);
    WritePicture(glass, folder.Path("glass.exr"), FileFormat::Exr, SampleType::Float32);
    const auto codes = [&](const std::string& arguments) {
        EXPECT_EQ(folder.Run(arguments + " -o out.png").exitCode, 0) << arguments;
        std::vector<int> list;
        for (const float sample : ReadPicture(folder.Path("out.png")).samples)
            list.push_back(static_cast<int>(std::lround(sample * 255)));
        return list;
    };
    for (const char* command :
         {"filter --width 1", "filter --width 3", "resize --scale 1", "resize --size 1x1 --filter nearest"}) {
        EXPECT_EQ(codes(fmt::format("{} half.exr", command)), std::vector<int>({188})) << command;
        EXPECT_EQ(codes(fmt::format("{} glass.exr", command)), std::vector<int>({124, 170, 231, 128})) << command;
        EXPECT_EQ(codes(fmt::format("{} half.exr --transfer raw", command)), std::vector<int>({128})) << command;
        EXPECT_EQ(codes(fmt::format("{} glass.exr --transfer raw", command)), std::vector<int>({26, 51, 102, 128}))
            << command;
    }
    Picture depth{1, 1, 1, SampleType::Unorm8, {0.5f}};
    WritePicture(depth, folder.Path("depth.png"), FileFormat::Png, SampleType::Unorm8);
    EXPECT_EQ(codes("dof half.exr --depth depth.png --focus 0.5 --aperture 0"), std::vector<int>({188}));
}

// JPEG keeps light to within its own losses.
TEST(LightOfFiles, JpegOfAFlatPictureIsItsCode) {
    const Folder folder;
    const Picture flat{32, 32, 3, SampleType::Float32, std::vector<float>(32 * 32 * 3, 0.5f)};
    WritePicture(flat, folder.Path("in.exr"), FileFormat::Exr, SampleType::Float32);
    ASSERT_EQ(folder.Run("filter in.exr -o out.jpg --width 3").exitCode, 0);
    for (const float sample : ReadPicture(folder.Path("out.jpg")).samples)
        ASSERT_NEAR(sample * 255, 188, 1);
    ASSERT_EQ(folder.Run("filter out.jpg -o back.exr --width 1").exitCode, 0);
    for (const float sample : ReadPicture(folder.Path("back.exr")).samples)
        ASSERT_NEAR(sample, ReferenceDecode(188 / 255.0), 0.01);
}

}  // namespace
}  // namespace boxcar
