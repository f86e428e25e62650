// boxcar filter and boxcar sat in integers, from file to file, against references in 128-bit integers and in double.
#include "tests/reference/exact.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

using reference::Border;

// A picture's codes, as the manual of --precision says: its own under raw, round(65535 linear light) under srgb.
reference::CodeImage CodesOf(const Picture& picture, bool srgb) {
    const double largest = picture.stored == SampleType::Unorm8 ? 255 : 65535;
    const size_t channels = picture.channels;
    reference::CodeImage image{static_cast<int>(picture.widthTexels), static_cast<int>(picture.heightTexels), {}};
    for (size_t at = 0; at < picture.samples.size(); at += channels) {
        const auto code = [&](size_t c) { return std::llround(picture.samples[at + c] * largest); };
        const bool hasAlpha = channels % 2 == 0;
        const double alpha = hasAlpha ? static_cast<double>(code(channels - 1)) / largest : 1;
        std::array<int64_t, 4> texel{};
        for (size_t c = 0; c < channels; c++) {
            const double light = ReferenceDecode(static_cast<double>(code(c)) / largest) * alpha;
            const bool isAlpha = hasAlpha && c + 1 == channels;
            texel[c] = srgb ? std::llround(65535 * (isAlpha ? alpha : light)) : code(c);
        }
        image.texels.push_back(texel);
    }
    return image;
}

std::map<std::string, std::vector<uint32_t>> ReadUintExr(const std::string& path, uint32_t width, uint32_t height) {
    Imf::InputFile file(path.c_str());
    std::map<std::string, std::vector<uint32_t>> channels;
    Imf::FrameBuffer frame;
    for (auto i = file.header().channels().begin(); i != file.header().channels().end(); ++i) {
        EXPECT_EQ(i.channel().type, Imf::UINT) << i.name();
        auto& samples = channels[i.name()];
        samples.resize(size_t{width} * height);
        frame.insert(i.name(), Imf::Slice::Make(Imf::UINT, samples.data(), file.header().dataWindow(), 4, 4 * width));
    }
    file.setFrameBuffer(frame);
    file.readPixels(0, static_cast<int>(height) - 1);
    return channels;
}

TEST(Sat, WritesExactTablesAsWholeNumbers) {
    const Folder folder;
    for (const SampleType stored : {SampleType::Unorm8, SampleType::Unorm16}) {
        const Picture picture = RandomPicture(49, 20, 4, stored);
        WritePicture(picture, folder.Path("in.png"), FileFormat::Png, stored);
        for (const bool srgb : {false, true}) {
            const auto codes = CodesOf(picture, srgb);
            for (int order = 1; order <= 3; order++) {
                const auto expected = reference::RepeatedTable(codes, order);
                for (const bool wide : {false, true}) {
                    const Outcome outcome =
                        folder.Run(fmt::format("sat in.png -o out.exr --transfer {} --precision {} --order {}",
                                               srgb ? "srgb" : "raw", wide ? "u64" : "u32", order));
                    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
                    const auto channels = ReadUintExr(folder.Path("out.exr"), 49, 20);
                    ASSERT_EQ(channels.size(), wide ? 8u : 4u);
                    for (size_t c = 0; c < 4; c++) {
                        const std::string name(1, "RGBA"[c]);
                        size_t wrong = 0;
                        for (size_t i = 0; i < expected.texels.size(); i++) {
                            const auto sum = static_cast<uint64_t>(expected.texels[i][c]);
                            wrong += channels.at(wide ? name + ".lo" : name)[i] != static_cast<uint32_t>(sum);
                            if (wide) wrong += channels.at(name + ".hi")[i] != static_cast<uint32_t>(sum >> 32);
                        }
                        EXPECT_EQ(wrong, 0u) << name << ", order " << order << (srgb ? ", srgb" : ", raw");
                    }
                }
            }
        }
    }
}

// A photograph's codes, and half-float light with a sun in it.
TEST(Sat, TablesOfAPhotographAndOfAnEnvironmentAreExact) {
    const Folder folder;
    for (const auto& [name, precision] :
         {std::pair("fruits.jpg", "u32"), std::pair("building.jpg", "u64"), std::pair("city.exr", "u64")}) {
        const Picture picture = ReadPicture(std::string(BOXCAR_ASSETS "/") + name);
        const bool isWide = precision == std::string("u64");
        reference::CodeImage codes;
        if (picture.stored == SampleType::Unorm8) {
            codes = CodesOf(picture, false);
        } else {
            codes = {static_cast<int>(picture.widthTexels), static_cast<int>(picture.heightTexels), {}};
            for (size_t i = 0; i < picture.samples.size(); i += 3) {
                std::array<int64_t, 4> texel{};
                for (size_t c = 0; c < 3; c++)
                    texel[c] = static_cast<int64_t>(std::ldexp(static_cast<double>(picture.samples[i + c]), 24));
                codes.texels.push_back(texel);
            }
        }
        ASSERT_EQ(folder
                      .Run(fmt::format("sat " BOXCAR_ASSETS "/{} -o out.exr --transfer raw --precision {}", name,
                                       precision))
                      .exitCode,
                  0);
        const auto channels = ReadUintExr(folder.Path("out.exr"), picture.widthTexels, picture.heightTexels);
        const auto expected = reference::RepeatedTable(codes, 1);
        size_t wrong = 0;
        for (size_t c = 0; c < 3; c++) {
            const std::string channel(1, "RGB"[c]);
            for (size_t i = 0; i < expected.texels.size(); i++) {
                const auto sum = static_cast<uint64_t>(expected.texels[i][c]);
                wrong += channels.at(isWide ? channel + ".lo" : channel)[i] != static_cast<uint32_t>(sum);
                if (isWide) wrong += channels.at(channel + ".hi")[i] != static_cast<uint32_t>(sum >> 32);
            }
        }
        EXPECT_EQ(wrong, 0u) << name;
    }
}

// Every half float is a whole multiple of 2^-24.
TEST(Sat, SumsHalfFloatsExactlyInTwoWords) {
    const Folder folder;
    Picture picture{16, 9, 1, SampleType::Float32, {}};
    for (int i = 0; i < 16 * 9; i++)
        picture.samples.push_back(std::ldexp(static_cast<float>(1024 + i), i % 30 - 24) *
                                  (i % 5 == 0 ? -1.0f : 1.0f));
    WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    ASSERT_EQ(folder.Run("sat in.pfm -o out.exr --precision u64").exitCode, 0);
    const auto channels = ReadUintExr(folder.Path("out.exr"), 16, 9);
    for (int y = 0; y < 9; y++)
        for (int x = 0; x < 16; x++) {
            int64_t sum = 0;
            for (int j = 0; j <= y; j++)
                for (int i = 0; i <= x; i++)
                    sum += static_cast<int64_t>(std::ldexp(picture.samples[static_cast<size_t>(j * 16 + i)], 24));
            const size_t at = static_cast<size_t>(y * 16 + x);
            ASSERT_EQ(uint64_t{channels.at("Y.hi")[at]} << 32 | channels.at("Y.lo")[at], static_cast<uint64_t>(sum));
        }
}

TEST(Sat, RefusesFloatsThatNoHalfIs) {
    const Folder folder;
    const Picture picture{2, 1, 1, SampleType::Float32, {0.5f, 0.1f}};
    WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    const Outcome fraction = folder.Run("sat in.pfm -o out.exr --precision u64");
    EXPECT_EQ(fraction.exitCode, 1);
    EXPECT_EQ(fraction.err,
              "boxcar: in.pfm: 0.1 at (1, 0) is not a half float; u64 sums half floats exactly, fp32 takes any\n");
    const Outcome narrow = folder.Run("sat in.pfm -o out.exr --precision u32");
    EXPECT_EQ(narrow.exitCode, 1);
    EXPECT_EQ(narrow.err, "boxcar: in.pfm: u32 sums 8 and 16-bit pictures; a float picture takes u64 or fp32\n");
}

TEST(Sat, OriginsKeepTheRowsInThePicturesOrder) {
    const Folder folder;
    const Picture picture{3, 3, 1, SampleType::Float32, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
    WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    ASSERT_EQ(folder.Run("sat in.pfm -o out.pfm --origin lower-left").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("out.pfm")).samples, std::vector<float>({12, 27, 45, 11, 24, 39, 7, 15, 24}));
    // The middle of 3 x 3 is the corner (1, 1): one column and row on one side of it, two on the other.
    ASSERT_EQ(folder.Run("sat in.pfm -o out.pfm --origin center").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("out.pfm")).samples, std::vector<float>({1, 2, 5, 4, 5, 11, 11, 13, 28}));
    ASSERT_EQ(folder.Run("sat in.pfm -o out.pfm --bias mean").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("out.pfm")).samples, std::vector<float>({-4, -7, -9, -5, -8, -9, -3, -3, 0}));
}

TEST(Sat, ExplainsWhatWasSummedAndHowManyBitsItTakes) {
    const Folder folder;
    WritePicture(RandomPicture(256, 256, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Outcome outcome = folder.Run("sat in.png -o out.exr --transfer raw --bias half --explain");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("P_s = log2 w + log2 h + P_i = 16.00 + 8 = 24.00 bits"), std::string::npos)
        << outcome.err;
    // Erratum: 40 bits for the second order, where the paper's text has 44.
    EXPECT_NE(outcome.err.find("40.00 (n = 2), 56.00 (n = 3)"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("bias     0.5 0.5 0.5 0.5 taken off"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("u32 holds boxes 4104 texels wide, tents of 64, parabolic kernels of 15"),
              std::string::npos)
        << outcome.err;
}

struct Shape {
    std::string flags;
    int order;
    double width, height;  // of the box it is made of; 0: a disc
};

// All shapes over all edges. EXR outputs hold the filtered values in linear light, or v / 255 under raw.
TEST(Filter, EveryShapeOverEveryEdgeIsTheAnalyticFilter) {
    const Folder folder;
    const Picture picture = RandomPicture(31, 22, 3, SampleType::Unorm8);
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    const double sigma = 2.5;
    const Shape shapes[] = {{"--width 5.5x3", 1, 5.5, 3},
                            {"--width 5.5x3 --precision u64", 1, 5.5, 3},
                            {"--width 4.5 --shape tent", 2, 4.5, 4.5},
                            {"--width 4.5x2.25 --shape parabolic", 3, 4.5, 2.25},
                            {"--width 2.5 --shape gauss", 3, 1.923 * sigma, 1.923 * sigma},
                            {"--width 2.5 --shape gauss --gauss-error 10", 2, 2.316 * sigma, 2.316 * sigma},
                            {"--width 9 --shape disc --disc-boxes 8", 1, 0, 0},
                            {"--width 9 --shape disc --disc-boxes 8 --precision u32", 1, 0, 0}};
    for (const bool srgb : {true, false}) {
        const auto light = ReferenceLight(picture, srgb);
        for (const Shape& shape : shapes) {
            for (const auto& [word, border] :
                 {std::pair("clip", Border::Clip), std::pair("zero", Border::Zero),
                  std::pair("repeat", Border::Repeat), std::pair("mirror", Border::Mirror)}) {
                if (srgb && border != Border::Mirror) continue;
                const std::string flags =
                    fmt::format("{} --edge {} --transfer {}", shape.flags, word, srgb ? "srgb" : "raw");
                const Outcome outcome = folder.Run("filter in.png -o out.exr " + flags);
                ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
                const Picture filtered = ReadPicture(folder.Path("out.exr"));
                for (int y = 0; y < 22; y++)
                    for (int x = 0; x < 31; x++) {
                        const glm::dvec4 expected = shape.width == 0
                                                        ? reference::DiscMean(light, x + 0.5, y + 0.5, 9, 8, border)
                                                        : reference::FilterMean(light, shape.order, x + 0.5, y + 0.5,
                                                                                shape.width, shape.height, border);
                        // Linear light is coded in 16 bits, so off by up to 1 / 131070.
                        for (int c = 0; c < 3; c++)
                            ASSERT_NEAR(filtered.samples[static_cast<size_t>((y * 31 + x) * 3 + c)], expected[c],
                                        2e-5)
                                << flags << " at " << x << ", " << y;
                    }
            }
        }
    }
}

// A tent of a whole width is the box of that width taken twice, to the last bit of an 8-bit file's codes.
TEST(Filter, TentsAndParabolicKernelsOfWholeWidthsAreTheRepeatedBox) {
    const Folder folder;
    const Picture picture = RandomPicture(40, 30, 1, SampleType::Unorm8);
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    const auto codes = CodesOf(picture, false);
    for (const auto& [shape, order] : {std::pair("box", 1), std::pair("tent", 2), std::pair("parabolic", 3)}) {
        const Outcome outcome = folder.Run(fmt::format(
            "filter in.png -o out.pfm --transfer raw --precision u32 --width 5x7 --shape {} --edge zero", shape));
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const Picture filtered = ReadPicture(folder.Path("out.pfm"));
        for (int y = 0; y < 30; y++)
            for (int x = 0; x < 40; x++) {
                const auto sum = static_cast<float>(reference::WholeSum(codes, order, x, y, 5, 7, Border::Zero)[0]);
                const auto mass = static_cast<float>(std::pow(35, order));
                ASSERT_EQ(filtered.samples[static_cast<size_t>(y * 40 + x)], sum / (mass * 255.0f)) << x << ", " << y;
            }
    }
}

// Floats that no half float is, and larger than the largest.
TEST(Filter, TentsTakeAnyFloat) {
    const Folder folder;
    Picture picture = RandomPicture(20, 16, 1, SampleType::Float32);
    for (const float value : {-3.14159f, 70000.0f}) {
        picture.samples[7] = value;
        WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
        ASSERT_EQ(folder.Run("filter in.pfm -o out.pfm --width 4.5 --shape tent").exitCode, 0);
        const Picture filtered = ReadPicture(folder.Path("out.pfm"));
        const auto light = ReferenceLight(picture, false);
        for (int y = 0; y < 16; y++)
            for (int x = 0; x < 20; x++) {
                const double expected = reference::FilterMean(light, 2, x + 0.5, y + 0.5, 4.5, 4.5, Border::Clip)[0];
                ASSERT_NEAR(filtered.samples[static_cast<size_t>(y * 20 + x)], expected,
                            1e-6 * std::max(1.0, std::abs(expected)));
            }
    }
    picture.samples[0] = 70000;
    WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    const Outcome outcome = folder.Run("filter in.pfm -o out.pfm --width 4.5 --shape tent --precision u64");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.err,
              "boxcar: in.pfm: 70000 at (0, 0) is beyond half floats; u64 sums values below 65536, fp32 takes any\n");
}

TEST(Filter, AMapOfWidthsGivesEachTexelItsOwn) {
    const Folder folder;
    const Picture picture = RandomPicture(30, 20, 3, SampleType::Unorm8),
                  map = RandomPicture(30, 20, 1, SampleType::Unorm8);
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    WritePicture(map, folder.Path("map.png"), FileFormat::Png, SampleType::Unorm8);
    const auto light = ReferenceLight(picture, false);
    for (const auto& [shape, order] : {std::pair("box", 1), std::pair("tent", 2), std::pair("parabolic", 3)}) {
        const Outcome outcome = folder.Run(
            fmt::format("filter in.png -o out.exr --transfer raw --width-map map.png --width-min 1 --width-max 9x5 "
                        "--shape {}",
                        shape));
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const Picture filtered = ReadPicture(folder.Path("out.exr"));
        for (int y = 0; y < 20; y++)
            for (int x = 0; x < 30; x++) {
                const double t = map.samples[static_cast<size_t>(y * 30 + x)];
                const auto expected =
                    reference::FilterMean(light, order, x + 0.5, y + 0.5, 1 + 8 * t, 1 + 4 * t, Border::Clip);
                ASSERT_NEAR(filtered.samples[static_cast<size_t>((y * 30 + x) * 3)], expected[0], 1e-5)
                    << shape << " at " << x << ", " << y;
            }
    }
}

TEST(Filter, WidthsOfAMapThatDoNotFitAreMarkedAndSaidSo) {
    const Folder folder;
    WritePicture(RandomPicture(30, 20, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    Picture map{30, 20, 1, SampleType::Unorm8, std::vector<float>(600, 0.0f)};
    map.samples[5] = map.samples[100] = 1;
    WritePicture(map, folder.Path("map.png"), FileFormat::Png, SampleType::Unorm8);
    const std::string flags = " --precision u32 --width-map map.png --width-min 3 --width-max 300";
    const Outcome outcome = folder.Run("filter in.png -o out.png" + flags);
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err,
              "boxcar: 2 of 600 texels ask for wider sums than u32 holds (256 x 256) and are marked, as magenta\n");
    const Picture filtered = ReadPicture(folder.Path("out.png"));
    EXPECT_EQ(std::vector<float>(&filtered.samples[15], &filtered.samples[18]), std::vector<float>({1, 0, 1}));
    ASSERT_EQ(folder.Run("filter in.png -o out.pfm" + flags).exitCode, 0);
    const Picture floats = ReadPicture(folder.Path("out.pfm"));
    EXPECT_TRUE(std::isnan(floats.samples[300]) && std::isnan(floats.samples[15]));
    EXPECT_FALSE(std::isnan(floats.samples[12]));
    WritePicture(RandomPicture(30, 20, 2, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Outcome grey = folder.Run("filter in.png -o out.png" + flags);
    EXPECT_TRUE(grey.err.starts_with(
        "boxcar: 2 of 600 texels ask for wider sums than u32 holds (256 x 256) and are marked, as white\n"))
        << grey.err;
    EXPECT_EQ(ReadPicture(folder.Path("out.png")).samples[10], 1);
}

// Sums of floats that end in infinity are no picture, whichever channel they are in.
TEST(Filter, RefusesSumsBeyondFloat32) {
    const Folder folder;
    Picture picture{8, 4, 3, SampleType::Float32, std::vector<float>(96, 0.5f)};
    for (size_t i = 1; i < 96; i += 3)
        picture.samples[i] = 3e38f;
    WritePicture(picture, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    for (const char* command : {"filter in.pfm -o out.pfm --width 3 --precision fp32",
                                "filter in.pfm -o out.png --width 3 --precision fp32", "sat in.pfm -o out.pfm"}) {
        const Outcome outcome = folder.Run(command);
        EXPECT_EQ(outcome.exitCode, 1) << command;
        EXPECT_EQ(outcome.err,
                  "boxcar: in.pfm: its sums are beyond float32's largest number; scale its samples down\n");
        EXPECT_EQ(folder.Names(), std::vector<std::string>({"in.pfm"}));
    }
}

// White under kernels that are long and thin: the range of a filter is that of both its axes, and each texel is 1.
TEST(Filter, WhiteStaysWhiteUnderFlatKernels) {
    const Folder folder;
    Picture white{1400, 6, 1, SampleType::Unorm8, std::vector<float>(1400 * 6, 1.0f)};
    WritePicture(white, folder.Path("white.png"), FileFormat::Png, SampleType::Unorm8);
    WritePicture(white, folder.Path("map.png"), FileFormat::Png, SampleType::Unorm8);
    const std::string map = "--width-map map.png --width-min 1 --width-max ";
    for (const std::string& flags :
         {std::string("--shape gauss --width 10x0.5"),
          std::string("--shape parabolic --width 150.5x1 --transfer raw"),
          std::string("--shape gauss --width 78x0.5 --transfer raw"),
          std::string("--shape tent --width 4103.5x1 --transfer raw"),
          std::string("--shape tent --width 5000.5 --transfer raw --precision u64"),
          std::string("--shape tent --width 16384x1 --transfer raw --precision u64"),
          std::string("--shape parabolic --width 501 --transfer raw --precision u64"),
          std::string("--shape parabolic --width 14999x1 --transfer raw --precision u64"),
          "--shape parabolic --transfer raw " + map + "15", "--shape parabolic --transfer raw " + map + "13",
          "--shape tent --transfer raw " + map + "255x1"}) {
        const Outcome outcome = folder.Run("filter white.png -o out.pfm " + flags);
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "") << flags;
        double worst = 0;
        for (const float sample : ReadPicture(folder.Path("out.pfm")).samples)
            worst = std::max(worst, std::abs(sample - 1.0));
        EXPECT_LE(worst, 1e-5) << flags;
    }
}

struct Refusal {
    std::string arguments;
    int exitCode;
    std::string line;
};

TEST(Filter, RefusesImpossibleCombinationsInOneLineEach) {
    const Folder folder;
    WritePicture(RandomPicture(20, 10, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    WritePicture(RandomPicture(4, 4, 1, SampleType::Unorm8), folder.Path("small.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Refusal refusals[] = {
        {"--shape tent --width 3 --precision fp32", 2,
         "--shape tent with --precision fp32: floats hold boxes and discs; leave out --precision"},
        {"--shape gauss --width 3 --precision fp32", 2,
         "--shape gauss with --precision fp32: floats hold boxes and discs; leave out --precision"},
        {"--width 3 --precision u32 --bias mean", 2,
         "--bias mean with --precision u32: integers do not round; a bias is for fp32"},
        {"--width 3 --shape tent --bias half", 2,
         "--bias half without --precision fp32: integers do not round; a bias is for fp32"},
        {"--width 3 --precision u64 --origin center", 2,
         "--origin center with --precision u64: integers do not round, and are summed from the corner; it is for "
         "fp32"},
        {"--width 3 --precision u64 --origin lower-left", 2,
         "--origin lower-left with --precision u64: integers do not round, and are summed from the corner; it is for "
         "fp32"},
        {"--width 3 --precision fp32 --origin center --edge mirror", 2,
         "--origin center with --edge mirror: sums over a repeated picture start at the corner"},
        {"--shape gauss --width 3 --gauss-error 1", 2,
         "--gauss-error 1: a Gaussian within 1 %: the nearest kernel, the parabolic one, is within 4.2 %"},
        {"--width 3 --gauss-error 5", 2, "--gauss-error with --shape box: it is for --shape gauss"},
        {"--width 3 --shape gauss --gauss-error nan", 2, "--gauss-error nan: expected percent, above 0"},
        {"--width 3 --shape tent --disc-sides 6", 2, "--disc-sides with --shape tent: it is for --shape disc"},
        {"--width 20000 --shape gauss", 2,
         "--shape gauss of that width is made of boxes of 38460 texels; at most 32768 are possible"},
        {"--width 9000 --shape tent --edge repeat", 1,
         "in.png: a kernel that reaches 9001 x 9001 texels over a repeated picture extends it to 18022 x 18012; this "
         "device takes 16384 a side: a smaller --width, a box, or --edge clip"},
        {"", 2, "--width is missing: W or WxH in texels, or a --width-map"},
        {"--width 3 --width-map small.png", 2, "--width and --width-map: give one of them"},
        {"--width 3 --width-max 4", 2, "--width-min and --width-max belong to --width-map"},
        {"--width-map small.png --width-min 3", 2,
         "--width-map needs --width-min and --width-max, the widths for 0 and for white"},
        {"--width-map small.png --width-min 3 --width-max 9", 1,
         "small.png: 4 x 4 texels; the map of widths must be as large as the picture, 20 x 10"},
        {"--width 65 --shape tent --precision u32 --transfer raw", 1,
         "in.png: a tent of 65 x 65 texels over codes up to 255 may not fit into 32 bits: u32 holds 64 x 64"},
        {"--width 647 --shape parabolic --transfer raw --precision u64", 1,
         "in.png: a parabolic kernel of 647 x 647 texels over codes up to 255 may not fit into 64 bits: u64 holds "
         "645 x 645"},
        {"--width 3001 --shape parabolic", 1,
         "in.png: a parabolic kernel of 3001 x 3001 texels is too wide for sums of 64 bits; 893 x 893 fits"},
        {"--width 257 --precision u32", 1,
         "in.png: a box of 257 x 257 texels over codes up to 65535 may not fit into 32 bits: u32 holds 256 x 256"},
    };
    for (const Refusal& refusal : refusals) {
        const Outcome outcome = folder.Run("filter in.png -o out.png " + refusal.arguments);
        EXPECT_EQ(outcome.exitCode, refusal.exitCode) << refusal.arguments;
        EXPECT_EQ(outcome.err, "boxcar: " + refusal.line + "\n");
        EXPECT_EQ(folder.Names(), std::vector<std::string>({"in.png", "small.png"})) << refusal.arguments;
    }
    const Outcome bits = folder.Run("filter in.png -o out.exr --width 3 --bits 16");
    EXPECT_EQ(bits.exitCode, 2);
    EXPECT_EQ(bits.err, "boxcar: --bits 16 with -o out.exr: it is for PNG\n");
    const Outcome twice = folder.Run("filter - -o out.png --width-map - --width-min 1 --width-max 2 < in.png");
    EXPECT_EQ(twice.exitCode, 2);
    EXPECT_EQ(twice.err, "boxcar: --width-map - and IN -: both would read standard input\n");
    const Refusal tables[] = {
        {"-o t.exr --order 2", 2, "--order 2 with --precision fp32: floats hold order 1; use u32 or u64"},
        {"-o t.pfm --precision u32", 2, "-o t.pfm: a table of integers is written as .exr"},
    };
    for (const Refusal& refusal : tables) {
        const Outcome outcome = folder.Run("sat in.png " + refusal.arguments);
        EXPECT_EQ(outcome.exitCode, refusal.exitCode) << refusal.arguments;
        EXPECT_EQ(outcome.err, "boxcar: " + refusal.line + "\n");
    }
}

// README and SummedAreaTableBytes: 32 bytes a texel for fp32 and u32, 64 for u64; source and result take 16 a word
// each.
TEST(Filter, TheTableTakesTheDocumentedMemory) {
    const Folder folder;
    WritePicture(RandomPicture(256, 128, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    for (const auto& [precision, tableBytes, sourceBytes] :
         {std::tuple("fp32", 32, 16), std::tuple("u32", 32, 16), std::tuple("u64", 64, 32)}) {
        const auto document = nlohmann::json::parse(
            folder.Run(fmt::format("filter in.png -o out.png --width 9 --bias none --json --precision {}", precision))
                .out);
        const auto& result = document.at("results").at(0);
        EXPECT_EQ(result.at("precision"), precision);
        EXPECT_EQ(result.at("table_bytes"), tableBytes * 256 * 128);
        // The one texel that stands for no map takes a page at the most.
        EXPECT_NEAR(result.at("device_bytes").get<double>(), (tableBytes + sourceBytes + 16) * 256 * 128, 4096);
    }
}

std::string Sha256(const std::string& path) {
    FILE* pipe = popen(fmt::format("sha256sum '{}'", path).c_str(), "r");
    std::string text(64, ' ');
    const size_t read = fread(text.data(), 1, text.size(), pipe);
    pclose(pipe);
    return text.substr(0, read);
}

// A picture of noise filtered from file to file, and the same by sliding sums on the CPU: one hash for both, and so
// for every driver. Large pictures go through the device in bands.
void ExpectOneHash(uint32_t width, uint32_t height, const std::string& expectedHash) {
    constexpr int kWidth = 33, kHeight = 129;
    const Folder folder;
    Picture picture{width, height, 1, SampleType::Unorm8, {}};
    picture.samples.resize(size_t{width} * height);
    uint64_t state = 1;
    for (float& sample : picture.samples) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        sample = static_cast<float>(state >> 56) / 255.0f;
    }
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    const Outcome outcome = folder.Run(
        fmt::format("filter in.png -o out.pfm --precision u32 --transfer raw --width {}x{}", kWidth, kHeight), "",
        1800);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;

    reference::WholeBoxSums sums(static_cast<int>(width), kWidth, kHeight);
    std::vector<float> masses;
    for (uint32_t x = 0; x < width; x++)
        masses.push_back(static_cast<float>(
            reference::WholeAxisMass(static_cast<int>(width), 1, static_cast<int>(x), kWidth, Border::Clip)));
    Picture expected{width, height, 1, SampleType::Float32, {}};
    expected.samples.reserve(picture.samples.size());
    const auto append = [&](const std::optional<std::vector<uint64_t>>& row) {
        if (!row) return;
        const auto y = static_cast<int>(expected.samples.size() / width);
        const auto rows =
            static_cast<float>(reference::WholeAxisMass(static_cast<int>(height), 1, y, kHeight, Border::Clip));
        for (uint32_t x = 0; x < width; x++)
            expected.samples.push_back(static_cast<float>((*row)[x]) / (masses[x] * rows * 255.0f));
    };
    std::vector<uint32_t> codes(width);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++)
            codes[x] = static_cast<uint32_t>(std::lround(picture.samples[size_t{y} * width + x] * 255));
        append(sums.Feed(codes));
    }
    for (int y = 0; y < kHeight / 2; y++)
        append(sums.FeedOutside());
    WritePicture(expected, folder.Path("expected.pfm"), FileFormat::Pfm, SampleType::Float32);
    const std::string hash = Sha256(folder.Path("expected.pfm"));
    EXPECT_EQ(Sha256(folder.Path("out.pfm")), hash);
    EXPECT_EQ(hash, expectedHash);
}

TEST(OneHash, OfALargePictureOnEveryDriver) {
    ExpectOneHash(4096, 4096, "7e65ba752ada9c5bad54bc2a40550d1bd828946f02ad8fe1c5f3666aa6cc3c9a");
}

TEST(OneHash, OfAPictureInBandsOnEveryDriver) {
    ExpectOneHash(16384, 1100, "a5c175a13178b966988c1577744b4c2ee8d0f041e069450aca78cd3924b6b4eb");
}

TEST(OneHash, OfTheLargestPictureOnEveryDriver) {
    if (!std::getenv("BOXCAR_LONG_TESTS")) GTEST_SKIP() << "takes minutes and 4 GiB: tools/run test --long";
    ExpectOneHash(16384, 8192, "e4a2a695964b9c5e53b2a9859ee96aacb152666db900f49b09ee0b50bec789c1");
}

}  // namespace
}  // namespace boxcar
