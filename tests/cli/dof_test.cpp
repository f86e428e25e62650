// boxcar dof: the lens against its formula and the mean over each texel's own circle, in double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "samples/app/bands.h"
#include "samples/app/disparity.h"
#include "tests/cli/program.h"
#include "tests/reference/order.h"

namespace boxcar {
namespace {

TEST(Dof, EachTexelIsTheMeanOverItsCircleOfConfusion) {
    const Folder folder;
    const Picture picture = RandomPicture(40, 30, 3, SampleType::Unorm8);
    Picture depth = RandomPicture(40, 30, 1, SampleType::Unorm8);
    for (float& sample : depth.samples)
        sample = std::max(sample, 1 / 255.0f);  // all known
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    WritePicture(depth, folder.Path("depth.png"), FileFormat::Png, SampleType::Unorm8);
    const auto light = ReferenceLight(picture, true);
    for (const auto& [focus, aperture] : {std::pair(0.25, 20.0), std::pair(1.0, 7.0), std::pair(0.5, 0.0)}) {
        const Outcome outcome = folder.Run(
            fmt::format("dof in.png --depth depth.png --focus {} --aperture {} -o out.exr", focus, aperture));
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const Picture blurred = ReadPicture(folder.Path("out.exr"));
        for (int y = 0; y < 30; y++)
            for (int x = 0; x < 40; x++) {
                const double d = depth.samples[static_cast<size_t>(y * 40 + x)];
                const double diameter = std::max(1.0, aperture * std::abs(d - focus));
                const auto expected =
                    reference::DiscMean(light, x + 0.5, y + 0.5, diameter, 16, reference::Border::Clip);
                for (int c = 0; c < 3; c++)
                    ASSERT_NEAR(blurred.samples[static_cast<size_t>((y * 40 + x) * 3 + c)], expected[c], 2e-5)
                        << "focus " << focus << ", aperture " << aperture << " at " << x << ", " << y;
            }
    }
}

TEST(Dof, WhatIsInFocusStaysSharpOnAPhotograph) {
    const Folder folder;
    const Picture photograph = ReadPicture(BOXCAR_ASSETS "/aloeL.jpg"),
                  depth = ReadPicture(BOXCAR_ASSETS "/aloeGT.png");
    const Outcome outcome =
        folder.Run("dof " BOXCAR_ASSETS "/aloeL.jpg --depth " BOXCAR_ASSETS
                   "/aloeGT.png --focus 0.5 --aperture 20 --disc-boxes 2 --method single -o out.png");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Picture focused = ReadPicture(folder.Path("out.png"));
    size_t inFocus = 0;
    for (size_t i = 0; i < depth.samples.size(); i++) {
        if (20 * std::abs(depth.samples[i] - 0.5) > 1) continue;
        inFocus++;
        for (size_t c = 0; c < 3; c++)
            ASSERT_NEAR(focused.samples[3 * i + c], photograph.samples[3 * i + c], 1.01 / 255) << "texel " << i;
    }
    EXPECT_GT(inFocus, 10000u);
}

// A red leaf in focus before a blue wall, far out of it. In one table the leaf reddens the wall around it, in layers
// it does not; the wall stays as it is in both, for it is all of one colour.
TEST(Dof, LayersKeepTheLightOfTheLeafOutOfTheWall) {
    const Folder folder;
    Picture picture{60, 40, 3, SampleType::Unorm8, {}}, depth{60, 40, 1, SampleType::Unorm8, {}};
    const auto isLeaf = [](size_t i) { return i % 60 >= 20 && i % 60 < 35; };
    for (size_t i = 0; i < 60 * 40; i++) {
        for (int c = 0; c < 3; c++)
            picture.samples.push_back(isLeaf(i) ? (c == 0 ? 1.0f : 0.0f) : (c == 2 ? 1.0f : 0.0f));
        depth.samples.push_back(isLeaf(i) ? 204 / 255.0f : 51 / 255.0f);
    }
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    WritePicture(depth, folder.Path("depth.png"), FileFormat::Png, SampleType::Unorm8);
    const auto redOfTheWall = [&](const std::string& method) {
        const Outcome outcome =
            folder.Run("dof in.png --depth depth.png --focus 0.8 --aperture 30 -o out.exr --method " + method);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        const Picture focused = ReadPicture(folder.Path("out.exr"));
        double red = 0;
        for (size_t i = 0; i < 60 * 40; i++) {
            if (isLeaf(i)) {
                EXPECT_NEAR(focused.samples[3 * i], 1, 1e-4) << method << ", texel " << i;
            } else {
                red += focused.samples[3 * i];
            }
        }
        return red;
    };
    const double single = redOfTheWall("single");
    EXPECT_GT(single, 100);
    EXPECT_LT(redOfTheWall("layered"), 0.01 * single);
}

// Before a wall in focus, the rim of a near leaf is half there at its edge and lets the wall through on its inner
// side: light falls across it all, without a step.
TEST(Dof, LayersMakeTheRimOfANearLeafSoftOnBothSides) {
    const Folder folder;
    Picture picture{80, 40, 3, SampleType::Unorm8, {}}, depth{80, 40, 1, SampleType::Unorm8, {}};
    for (size_t i = 0; i < 80 * 40; i++) {
        const bool isLeaf = i % 80 < 40;
        for (int c = 0; c < 3; c++)
            picture.samples.push_back(isLeaf == (c == 0) ? 1.0f : 0.0f);
        depth.samples.push_back(isLeaf ? 204 / 255.0f : 51 / 255.0f);
    }
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    WritePicture(depth, folder.Path("depth.png"), FileFormat::Png, SampleType::Unorm8);
    const Outcome outcome =
        folder.Run("dof in.png --depth depth.png --focus 0.2 --aperture 35 -o out.exr --method layered");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Picture focused = ReadPicture(folder.Path("out.exr"));
    const auto red = [&](int x) { return focused.samples[static_cast<size_t>(3 * (20 * 80 + x))]; };
    EXPECT_NEAR(0.5 * (red(39) + red(40)), 0.5, 0.04);
    EXPECT_NEAR(red(10), 1, 1e-4);
    EXPECT_NEAR(red(70), 0, 1e-4);
    for (int x = 10; x < 70; x++)  // a disc of 21 texels is 0.06 of its area at its widest column
        EXPECT_NEAR(red(x) - red(x + 1), 0.03, 0.045) << "column " << x;
}

// The nearest is looked for among all, the slow way.
TEST(Dof, UnknownDepthTakesTheNearestKnownValue) {
    std::mt19937 random(61);
    for (const Extent2D extent : {Extent2D{1, 1}, Extent2D{1, 9}, Extent2D{13, 1}, Extent2D{23, 17}}) {
        for (const uint32_t oneIn : {2u, 10u, 60u}) {
            std::vector<float> depth;
            for (uint64_t i = 0; i < extent.Texels(); i++)
                depth.push_back(random() % oneIn == 0 ? static_cast<float>(1 + i) : NAN);
            std::vector<float> filled = depth;
            const bool isAnyKnown = FillUnknown(filled, extent);
            const auto w = static_cast<int>(extent.widthTexels), h = static_cast<int>(extent.heightTexels);
            const auto distance = [&](int x, int y, float value) {
                const int at = static_cast<int>(value) - 1;
                return (at % w - x) * (at % w - x) + (at / w - y) * (at / w - y);
            };
            for (int y = 0; y < h; y++)
                for (int x = 0; x < w; x++) {
                    int nearest = -1;
                    for (const float value : depth)
                        if (value > 0 && (nearest < 0 || distance(x, y, value) < nearest))
                            nearest = distance(x, y, value);
                    const float taken = filled[static_cast<size_t>(y * w + x)];
                    ASSERT_EQ(isAnyKnown, nearest >= 0);
                    if (nearest < 0)
                        ASSERT_TRUE(std::isnan(taken));
                    else
                        ASSERT_EQ(distance(x, y, taken), nearest) << x << ", " << y;
                }
        }
    }
}

TEST(Dof, RefusesWhatItCannotDoInOneLine) {
    const Folder folder;
    WritePicture(RandomPicture(8, 8, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    WritePicture(RandomPicture(4, 4, 1, SampleType::Unorm8), folder.Path("small.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const auto expect = [&](const std::string& arguments, int exitCode, const std::string& line) {
        const Outcome outcome = folder.Run("dof in.png -o out.png " + arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments;
        EXPECT_EQ(outcome.err, "boxcar: " + line + "\n");
    };
    expect("--depth in.png --focus 2 --aperture 9", 2,
           "--focus 2: expected 0 to 1, as white is 1 in this depth; --depth-scale 1 keeps the file's numbers");
    expect("--depth in.png --focus 0.5 --aperture -1", 2, "--aperture -1: expected texels, 0 to 32768");
    expect("--depth none.png --focus 0.5 --aperture 9", 1, "none.png: cannot be read: No such file or directory");
    expect("--depth small.png --focus 0.5 --aperture 9", 1,
           "small.png: 4 x 4 texels; the depth must be as large as the picture, 8 x 8");
    WritePicture(RandomPicture(8, 8, 4, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    expect("--depth in.png --focus 0.5 --aperture 9 --method layered", 1,
           "in.png: 4 channels; --method layered takes pictures without alpha");
    Picture lamp{8, 8, 3, SampleType::Float32, std::vector<float>(8 * 8 * 3, 0.5f)};
    lamp.samples[30] = 1e6f;
    WritePicture(lamp, folder.Path("lamp.exr"), FileFormat::Exr, SampleType::Float32);
    const Outcome outcome =
        folder.Run("dof lamp.exr --depth in.png --focus 0.5 --aperture 9 --method layered -o out.exr");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.err,
              "boxcar: lamp.exr: a sample of 1e+06; --method layered takes at most 16, --method single takes any\n");
}

// Bands cover every row once, and each reads as far as a kernel reaches.
TEST(Bands, CoverEveryRowOnceWithTheRowsThatAKernelReaches) {
    for (const uint32_t height : {1u, 100u, 1000u}) {
        for (const uint32_t reach : {0u, 1u, 30u, 400u}) {
            const Extent2D extent{16, height};
            uint32_t next = 0;
            for (const Band& band : PlanBands(extent, reach, 16 * 100)) {
                EXPECT_EQ(band.firstRow, next);
                next += band.rows;
                EXPECT_EQ(band.firstRead, band.firstRow > reach ? band.firstRow - reach : 0);
                EXPECT_EQ(band.firstRead + band.rowsRead, std::min(next + reach, height));
                if (2 * reach < 100) {
                    EXPECT_LE(band.rowsRead, 100u);
                }
            }
            EXPECT_EQ(next, height);
        }
    }
}

}  // namespace
}  // namespace boxcar
