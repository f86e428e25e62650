// boxcar filter and boxcar dof as people call them, without --precision: on photographs and on pictures that floats
// cannot sum, against the definition in double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <random>

#include "tests/cli/program.h"
#include "tests/reference/separable.h"

namespace boxcar {
namespace {

using reference::Border;

constexpr double kMostCodes = 0.51;     // from the definition: 0.5 is the file's own rounding
constexpr double kMostRelative = 1e-5;  // of the local magnitude, for floats

// Photographs put side by side until there are so many texels, with as much noise as a camera's.
Picture PhotographOf(uint32_t widthTexels, uint32_t heightTexels, SampleType stored) {
    const Picture tiles[] = {ReadPicture(BOXCAR_ASSETS "/fruits.jpg"), ReadPicture(BOXCAR_ASSETS "/building.jpg"),
                             ReadPicture(BOXCAR_ASSETS "/aloeL.jpg")};
    const int largest = stored == SampleType::Unorm8 ? 255 : 65535;
    std::minstd_rand random(7);
    Picture picture{widthTexels, heightTexels, 3, stored, {}};
    picture.samples.reserve(size_t{widthTexels} * heightTexels * 3);
    for (uint32_t y = 0; y < heightTexels; y++)
        for (uint32_t x = 0; x < widthTexels; x++) {
            const Picture& tile = tiles[(x / 400 + y / 400) % 3];
            const size_t at = size_t{y % 400} * tile.widthTexels + x % 400;
            for (size_t c = 0; c < 3; c++) {
                const int noise = static_cast<int>(random() % 5) - 2;
                const double code = std::round(static_cast<double>(tile.samples[3 * at + c]) * largest) + noise;
                picture.samples.push_back(static_cast<float>(std::clamp(code, 0.0, 1.0 * largest) / largest));
            }
        }
    return picture;
}

// 221 above or left of 21: what is summed of the one is lost in the other where sums are rounded.
Picture TwoTones(uint32_t widthTexels, uint32_t heightTexels, bool beside) {
    Picture picture{widthTexels, heightTexels, 1, SampleType::Unorm8, {}};
    picture.samples.reserve(size_t{widthTexels} * heightTexels);
    for (uint32_t y = 0; y < heightTexels; y++)
        for (uint32_t x = 0; x < widthTexels; x++)
            picture.samples.push_back((beside ? 2 * x < widthTexels : 2 * y < heightTexels) ? 221 / 255.0f
                                                                                            : 21 / 255.0f);
    return picture;
}

// The samples of the file that should come out, not rounded: under srgb encoded, and divided by alpha.
double ExpectedSample(const glm::dvec4& mean, size_t channel, uint32_t channels, bool srgb) {
    const bool hasAlpha = channels % 2 == 0;
    const int c = static_cast<int>(channel);
    if (!srgb || (hasAlpha && channel + 1 == channels)) return mean[c];
    const double alpha = hasAlpha ? mean[static_cast<int>(channels) - 1] : 1;
    return alpha > 0 ? std::clamp(ReferenceEncode(mean[c] / alpha), 0.0, 1.0) : 0;
}

struct Shape {
    const char* flags;
    int order;
    double widthTexels, heightTexels;
};
constexpr Shape kShapes[] = {{"--width 3", 1, 3, 3},
                             {"--width 4", 1, 4, 4},
                             {"--width 8.6x2.25", 1, 8.6f, 2.25f},
                             {"--width 33", 1, 33, 33},
                             {"--shape tent --width 5", 2, 5, 5},
                             {"--shape tent --width 3.4", 2, 3.4f, 3.4f},
                             {"--shape tent --width 33.5x1", 2, 33.5f, 1},
                             {"--shape parabolic --width 5x4.25", 3, 5, 4.25f},
                             {"--shape parabolic --width 7", 3, 7, 7},
                             {"--shape gauss --width 2.5", 3, 1.923f * 2.5f, 1.923f * 2.5f}};

struct Edge {
    const char* word;
    Border border;
};
constexpr Edge kEdges[] = {
    {"clip", Border::Clip}, {"zero", Border::Zero}, {"repeat", Border::Repeat}, {"mirror", Border::Mirror}};

// The most that a sample of the output is from its definition, in its codes.
double WorstOfFilter(const Folder& folder, const Picture& picture, const Shape& shape, const Edge& edge, bool srgb) {
    const Outcome outcome = folder.Run(fmt::format("filter in.png -o out.png {} --edge {} --transfer {}", shape.flags,
                                                   edge.word, srgb ? "srgb" : "raw"),
                                       "", 900);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Picture filtered = ReadPicture(folder.Path("out.png"));
    if (filtered.stored != picture.stored || filtered.channels != picture.channels) return INFINITY;
    const double largest = picture.stored == SampleType::Unorm8 ? 255 : 65535;
    const auto means = reference::FilteredPicture(ReferenceLight(picture, srgb), shape.order, shape.widthTexels,
                                                  shape.heightTexels, edge.border);
    double worst = 0;
    for (size_t i = 0; i < filtered.samples.size(); i++) {
        const double expected =
            ExpectedSample(means.texels[i / picture.channels], i % picture.channels, picture.channels, srgb);
        worst = std::max(worst, std::abs(filtered.samples[i] - expected) * largest);
    }
    return worst;
}

TEST(Default, EveryShapeAndEdgeIsWithinHalfACode) {
    const Folder folder;
    for (const SampleType stored : {SampleType::Unorm8, SampleType::Unorm16}) {
        for (const uint32_t channels : {3u, 4u}) {
            const Picture picture =
                channels == 3 ? PhotographOf(230, 90, stored) : RandomPicture(120, 70, channels, stored);
            WritePicture(picture, folder.Path("in.png"), FileFormat::Png, stored);
            // Every shape with some edge, and every edge with some shape.
            for (size_t i = 0; i < std::size(kShapes); i++)
                for (const bool srgb : {false, true})
                    EXPECT_LE(WorstOfFilter(folder, picture, kShapes[i], kEdges[(i + srgb) % 4], srgb), kMostCodes)
                        << kShapes[i].flags << " --edge " << kEdges[(i + srgb) % 4].word << ", " << channels
                        << " channels" << (srgb ? ", srgb" : ", raw")
                        << (stored == SampleType::Unorm8 ? ", 8 bits" : ", 16 bits");
        }
    }
}

TEST(Default, APhotographOfTwoMegapixelsIsWithinHalfACode) {
    const Folder folder;
    const Picture picture = PhotographOf(1800, 1200, SampleType::Unorm8);
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    EXPECT_LE(WorstOfFilter(folder, picture, kShapes[0], kEdges[0], true), kMostCodes);
    EXPECT_LE(WorstOfFilter(folder, picture, kShapes[4], kEdges[3], false), kMostCodes);
}

// The flat lower half of the picture comes out as it is.
TEST(Default, TwoTonesStayTwoTones) {
    const Folder folder;
    WritePicture(TwoTones(1500, 1000, false), folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    ASSERT_EQ(folder.Run("filter in.png -o out.png --width 3").exitCode, 0);
    const Picture filtered = ReadPicture(folder.Path("out.png"));
    const auto wrong = std::count_if(filtered.samples.begin() + 502 * 1500, filtered.samples.end(),
                                     [](float sample) { return sample != 21 / 255.0f; });
    EXPECT_EQ(wrong, 0);

    const Outcome floats = folder.Run("filter in.png -o out.png --width 3 --precision fp32");
    EXPECT_EQ(floats.exitCode, 0);
    EXPECT_NE(floats.err.find("fp32 sums round: the error of a sample is at most"), std::string::npos) << floats.err;
}

TEST(Default, LargePicturesAreWithinHalfACode) {
    if (!std::getenv("BOXCAR_LONG_TESTS")) GTEST_SKIP() << "takes minutes and 8 GiB: tools/run test --long";
    const Folder folder;
    for (const auto& [width, height] : {std::pair(4000u, 3000u), std::pair(6000u, 4000u)}) {
        const Picture picture = PhotographOf(width, height, SampleType::Unorm8);
        WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
        EXPECT_LE(WorstOfFilter(folder, picture, kShapes[0], kEdges[0], true), kMostCodes) << width;
    }
    for (const bool beside : {false, true}) {
        const Picture picture = TwoTones(8192, 4096, beside);
        WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
        EXPECT_LE(WorstOfFilter(folder, picture, kShapes[0], kEdges[0], true), kMostCodes);
        EXPECT_LE(WorstOfFilter(folder, picture, kShapes[2], kEdges[3], false), kMostCodes);
    }
}

// The most that a sample is from the definition, as a share of what the kernel finds of magnitudes there. Where it
// finds none, the sample has to be 0.
double WorstShare(const Folder& folder, const Picture& picture, const Shape& shape, const Edge& edge) {
    WritePicture(picture, folder.Path("in.exr"), FileFormat::Exr, SampleType::Float32);
    const Outcome outcome =
        folder.Run(fmt::format("filter in.exr -o out.exr {} --edge {}", shape.flags, edge.word), "", 600);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Picture filtered = ReadPicture(folder.Path("out.exr"));
    reference::DoubleImage values = ReferenceLight(picture, false), magnitudes = values;
    for (glm::dvec4& texel : magnitudes.texels)
        texel = glm::abs(texel);
    const auto filter = [&](const reference::DoubleImage& image) {
        return reference::FilteredPicture(image, shape.order, shape.widthTexels, shape.heightTexels, edge.border);
    };
    const auto expected = filter(values), found = filter(magnitudes);
    double worst = 0;
    for (size_t i = 0; i < filtered.samples.size(); i++) {
        const int c = static_cast<int>(i % picture.channels);
        const double difference = std::abs(filtered.samples[i] - expected.texels[i / picture.channels][c]);
        const double magnitude = found.texels[i / picture.channels][c];
        worst = std::max(worst, magnitude > 0 ? difference / magnitude : difference > 0 ? INFINITY : 0);
    }
    return worst;
}

TEST(Default, ALampDoesNotDisturbTheDark) {
    const Folder folder;
    Picture lamp{96, 64, 3, SampleType::Float32, std::vector<float>(96 * 64 * 3, 0.02f)};
    for (size_t c = 0; c < 3; c++)
        lamp.samples[(30 * 96 + 40) * 3 + c] = 1e6f;
    for (size_t i = 0; i < std::size(kShapes); i++)
        EXPECT_LE(WorstShare(folder, lamp, kShapes[i], kEdges[i % 4]), kMostRelative) << kShapes[i].flags;
    EXPECT_LE(WorstShare(folder, lamp, {"--shape parabolic --width 101", 3, 101, 101}, kEdges[0]), kMostRelative);
    const Outcome stats = folder.Run("filter in.exr -o out.exr --shape parabolic --width 101 --stats");
    EXPECT_NE(stats.err.find("in steps of"), std::string::npos) << stats.err;
    EXPECT_NE(stats.err.find("rounds"), std::string::npos) << "one table does not hold them: " << stats.err;
}

// Wide kernels, and discs, that only touch the lamp.
TEST(Default, ALampAtTheRimCountsForWhatIsCovered) {
    const Folder folder;
    Picture row{2600, 1, 1, SampleType::Float32, std::vector<float>(2600, 0.02f)};
    row.samples[1300] = 1e6f;
    for (const auto& [flags, width] :
         {std::pair("--width 1023.3x1", 1023.3f), std::pair("--width 2047.1x1", 2047.1f)})
        EXPECT_LE(WorstShare(folder, row, {flags, 1, width, 1}, kEdges[1]), kMostRelative) << flags;

    std::mt19937 random(12);
    Picture lamp{61, 61, 1, SampleType::Float32, {}};
    for (int i = 0; i < 61 * 61; i++)
        lamp.samples.push_back(static_cast<float>(random() % 1000) * 2e-5f);
    lamp.samples[30 * 61 + 30] = 1e6f;
    WritePicture(lamp, folder.Path("in.exr"), FileFormat::Exr, SampleType::Float32);
    const auto light = ReferenceLight(lamp, false);
    for (const float diameter : {7.784538269042969f, 23.353614807128906f, 36.738f, 57.3f}) {
        const Outcome outcome =
            folder.Run(fmt::format("filter in.exr -o out.exr --shape disc --width {:.9g}", diameter));
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const Picture filtered = ReadPicture(folder.Path("out.exr"));
        for (int y = 0; y < 61; y++)
            for (int x = 0; x < 61; x++) {
                const double expected = reference::DiscMean(light, x + 0.5, y + 0.5, diameter, 16, Border::Clip).x;
                ASSERT_NEAR(filtered.samples[static_cast<size_t>(y * 61 + x)] / expected, 1, kMostRelative)
                    << "diameter " << diameter << " at " << x << ", " << y;
            }
    }
}

// A gamma so steep that the light of most codes is below every float.
TEST(Default, LightBelowEveryFloatEnds) {
    const Folder folder;
    for (const double gamma : {0.0002, 0.001, 0.01}) {
        Picture picture = RandomPicture(8, 8, 1, SampleType::Unorm8);
        picture.colorSpace.gamma = gamma;
        WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
        for (const char* out : {"out.pfm", "out.png"})
            EXPECT_EQ(folder.Run(fmt::format("filter in.png -o {} --width 3", out), "", 60).exitCode, 0) << gamma;
    }
}

// The width that a refusal names is taken.
TEST(Default, TheWidthNamedByARefusalFits) {
    const Folder folder;
    WritePicture(RandomPicture(20, 10, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    for (const char* width : {"1200.5", "1291"}) {
        const Outcome refused =
            folder.Run(fmt::format("filter in.png -o out.png --shape parabolic --width {}", width));
        ASSERT_EQ(refused.exitCode, 1);
        const size_t at = refused.err.find("64 bits; ");
        ASSERT_NE(at, std::string::npos) << refused.err;
        const int named = std::atoi(refused.err.c_str() + at + 9);
        const Outcome taken = folder.Run(fmt::format("filter in.png -o out.png --shape parabolic --width {}", named));
        EXPECT_EQ(taken.exitCode, 0) << taken.err;
    }
}

// What floats lose is told whatever is taken off, and so is what the steps of integers asked for by name lose.
TEST(Default, WhatANamedPrecisionLosesIsTold) {
    const Folder folder;
    Picture dots{1500, 1000, 1, SampleType::Unorm8, std::vector<float>(1500 * 1000, 0.0f)};
    for (size_t i = 0; i < dots.samples.size(); i += 50)
        dots.samples[i] = 1 / 255.0f;
    WritePicture(dots, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    const Outcome half = folder.Run("filter in.png -o out.png --width 3 --transfer raw --precision fp32 --bias half");
    EXPECT_NE(half.err.find("the error of a sample is at most"), std::string::npos) << half.err;
    WritePicture(PhotographOf(60, 40, SampleType::Unorm16), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm16);
    const Outcome named = folder.Run("filter in.png -o out.png --width 3 --precision u64");
    EXPECT_EQ(
        named.err,
        "boxcar: in.png: u64 by name sums light in steps of 1 / 65535: the error of a sample is at most 6.5 codes; "
        "leave out --precision for exact sums\n");
}

// Floats of both signs, over the whole range of normal floats, and half floats of an environment with a sun.
TEST(Default, FloatsOfAnySizeAreRightWhereTheyAre) {
    const Folder folder;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> exponent(-36, 36);
    Picture wild{40, 30, 3, SampleType::Float32, {}};
    for (int i = 0; i < 40 * 30 * 3; i++)
        wild.samples.push_back(std::pow(10.0f, exponent(random)) * (random() % 2 == 0 ? 1.0f : -1.0f));
    Picture huge{8, 6, 1, SampleType::Float32, std::vector<float>(48, 3e38f)};
    const Picture city = ReadPicture(BOXCAR_ASSETS "/city.exr");
    for (const size_t i : {0u, 2u, 4u, 6u, 9u}) {
        EXPECT_LE(WorstShare(folder, wild, kShapes[i], kEdges[0]), kMostRelative) << kShapes[i].flags;
        EXPECT_LE(WorstShare(folder, huge, kShapes[i], kEdges[0]), kMostRelative) << kShapes[i].flags;
    }
    EXPECT_LE(WorstShare(folder, city, kShapes[0], kEdges[3]), kMostRelative);
    EXPECT_LE(WorstShare(folder, city, kShapes[9], kEdges[0]), kMostRelative);
}

struct Circles {
    Picture depth;
    double focus, aperture;

    double DiameterAt(size_t texel) const { return std::max(1.0, aperture * std::abs(depth.samples[texel] - focus)); }
};

// The means over the circles, of some texels.
template <typename Check>
void ForSomeTexels(const Picture& picture, const reference::DoubleImage& light, const Circles& circles, Check check) {
    std::mt19937 random(9);
    for (int i = 0; i < 400; i++) {
        const size_t x = random() % picture.widthTexels, y = random() % picture.heightTexels;
        const size_t at = y * picture.widthTexels + x;
        check(at, reference::DiscMean(light, static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5,
                                      circles.DiameterAt(at), 16, Border::Clip));
    }
}

TEST(Default, DepthOfFieldIsWithinHalfACode) {
    const Folder folder;
    Circles circles{RandomPicture(300, 200, 1, SampleType::Unorm8), 0.5, 60};
    for (float& sample : circles.depth.samples)
        sample = std::max(sample, 1 / 255.0f);  // all known
    WritePicture(circles.depth, folder.Path("depth.png"), FileFormat::Png, SampleType::Unorm8);
    for (const SampleType stored : {SampleType::Unorm8, SampleType::Unorm16}) {
        const double largest = stored == SampleType::Unorm8 ? 255 : 65535;
        const Picture picture = PhotographOf(300, 200, stored);
        WritePicture(picture, folder.Path("in.png"), FileFormat::Png, stored);
        for (const bool srgb : {false, true}) {
            const Outcome outcome = folder.Run(
                fmt::format("dof in.png --depth depth.png --focus 0.5 --aperture 60 -o out.png --transfer {}",
                            srgb ? "srgb" : "raw"));
            ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
            const Picture focused = ReadPicture(folder.Path("out.png"));
            ForSomeTexels(picture, ReferenceLight(picture, srgb), circles, [&](size_t at, const glm::dvec4& mean) {
                for (size_t c = 0; c < 3; c++)
                    EXPECT_NEAR(focused.samples[3 * at + c] * largest, ExpectedSample(mean, c, 3, srgb) * largest,
                                kMostCodes)
                        << largest << (srgb ? ", srgb" : ", raw") << ", diameter " << circles.DiameterAt(at);
            });
        }
    }
}

// Whatever its depths are: one color stays it, the darkest too, and what is in focus stays as it is.
TEST(Default, LayersKeepOneColorAndWhatIsSharp) {
    const Folder folder;
    Picture depth = RandomPicture(90, 60, 1, SampleType::Unorm8);
    for (size_t i = 0; i < depth.samples.size(); i++)  // steps of some size, all known
        depth.samples[i] = depth.samples[i / 90 / 20 * 20 * 90 + i % 90 / 15 * 15] * 0.5f + 0.25f;
    WritePicture(depth, folder.Path("depth.png"), FileFormat::Png, SampleType::Unorm8);
    for (const SampleType stored : {SampleType::Unorm8, SampleType::Unorm16}) {
        const double largest = stored == SampleType::Unorm8 ? 255 : 65535;
        Picture flat{90, 60, 3, stored, {}};
        for (int i = 0; i < 90 * 60; i++)
            for (const float code : {1.0f, 7.0f, 0.6f * static_cast<float>(largest)})
                flat.samples.push_back(std::round(code) / static_cast<float>(largest));
        const Picture sharp = PhotographOf(90, 60, stored);
        for (const auto& [picture, aperture] : {std::pair(&std::as_const(flat), 60), std::pair(&sharp, 0)}) {
            WritePicture(*picture, folder.Path("in.png"), FileFormat::Png, stored);
            const Outcome outcome = folder.Run(fmt::format(
                "dof in.png --depth depth.png --focus 0.5 --aperture {} --method layered -o out.png", aperture));
            ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
            const Picture focused = ReadPicture(folder.Path("out.png"));
            for (size_t i = 0; i < focused.samples.size(); i++)
                ASSERT_NEAR(focused.samples[i] * largest, picture->samples[i] * largest, kMostCodes)
                    << largest << ", aperture " << aperture << ", sample " << i;
        }
    }
}

TEST(Default, DepthOfFieldOfALampDoesNotDisturbTheDark) {
    const Folder folder;
    Circles circles{RandomPicture(160, 90, 1, SampleType::Unorm8), 0.5, 40};
    for (float& sample : circles.depth.samples)
        sample = std::max(sample, 1 / 255.0f);
    WritePicture(circles.depth, folder.Path("depth.png"), FileFormat::Png, SampleType::Unorm8);
    Picture lamp{160, 90, 3, SampleType::Float32, std::vector<float>(160 * 90 * 3, 0.02f)};
    for (size_t c = 0; c < 3; c++)
        lamp.samples[(30 * 160 + 40) * 3 + c] = 1e6f;
    WritePicture(lamp, folder.Path("in.exr"), FileFormat::Exr, SampleType::Float32);
    const Outcome outcome = folder.Run("dof in.exr --depth depth.png --focus 0.5 --aperture 40 -o out.exr");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Picture focused = ReadPicture(folder.Path("out.exr"));
    ForSomeTexels(lamp, ReferenceLight(lamp, false), circles, [&](size_t at, const glm::dvec4& mean) {
        EXPECT_NEAR(focused.samples[3 * at] / mean.x, 1, kMostRelative) << "diameter " << circles.DiameterAt(at);
    });
}

}  // namespace
}  // namespace boxcar
