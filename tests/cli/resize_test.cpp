// boxcar resize and derive, from file to file, against the analytic spline in double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/exponential.hpp>

#include "tests/cli/program.h"
#include "tests/reference/bspline.h"

namespace boxcar {
namespace {

using Kernel = double (*)(double);

double Nearest(double x) {
    return reference::BSpline(0, x);
}
double Linear(double x) {
    return reference::BSpline(1, x);
}
double Cubic(double x) {
    return reference::BSpline(3, x);
}

Picture WriteFloats(const Folder& folder, uint32_t width, uint32_t height) {
    const Picture picture = RandomPicture(width, height, 3, SampleType::Unorm8);
    Picture floats = picture;
    floats.stored = SampleType::Float32;
    WritePicture(floats, folder.Path("in.exr"), FileFormat::Exr, SampleType::Float32);
    return floats;
}

template <typename Expected>
void ExpectTexels(const Folder& folder, uint32_t width, uint32_t height, double tolerance, const std::string& what,
                  Expected expected) {
    const Picture picture = ReadPicture(folder.Path("out.exr"));
    ASSERT_EQ(picture.widthTexels, width) << what;
    ASSERT_EQ(picture.heightTexels, height) << what;
    ASSERT_EQ(picture.channels, 3u);
    for (uint32_t y = 0; y < height; y++)
        for (uint32_t x = 0; x < width; x++) {
            const glm::dvec4 texel = expected(x, y);
            for (int c = 0; c < 3; c++)
                ASSERT_NEAR(picture.samples[(y * width + x) * 3 + c], texel[c], tolerance)
                    << what << " at " << x << ", " << y;
        }
}

TEST(Resize, LargerPicturesAreTheSplineWhereItSays) {
    const Folder folder;
    const Picture picture = WriteFloats(folder, 17, 11);
    const auto light = ReferenceLight(picture, false), coefficients = reference::SplineCoefficients(light);
    const std::tuple<std::string, Kernel, const reference::DoubleImage&> filters[] = {
        {"nearest", Nearest, light},
        {"linear", Linear, light},
        {"bspline", Cubic, light},
        {"interpolating-bspline", Cubic, coefficients},
        {"catmull-rom", reference::CatmullRom, light}};
    for (const auto& [filter, kernel, image] : filters) {
        const std::string flags = "resize in.exr -o out.exr --filter " + filter;
        ASSERT_EQ(folder.Run(flags + " --scale 3").exitCode, 0);
        ExpectTexels(folder, 51, 33, 5e-6, flags, [&](uint32_t x, uint32_t y) {
            return reference::CubicSum(image, (x + 0.5) / 3, (y + 0.5) / 3, kernel, kernel);
        });
        ASSERT_EQ(folder.Run(flags + " --size 40x11").exitCode, 0);
        ExpectTexels(folder, 40, 11, 5e-6, flags, [&](uint32_t x, uint32_t y) {
            return reference::CubicSum(image, (x + 0.5) * 17 / 40, y + 0.5, kernel, kernel);
        });
    }
}

TEST(Resize, SmallerPicturesAreMeansUnderStretchedKernels) {
    const Folder folder;
    const auto light = ReferenceLight(WriteFloats(folder, 60, 40), false);
    const std::pair<const char*, Kernel> filters[] = {
        {"linear", Linear}, {"bspline", Cubic}, {"catmull-rom", reference::CatmullRom}};
    for (const auto& [filter, kernel] : filters) {
        ASSERT_EQ(folder.Run(fmt::format("resize in.exr -o out.exr --scale 0.3 --filter {}", filter)).exitCode, 0);
        ExpectTexels(folder, 18, 12, 5e-6, filter, [&, k = kernel](uint32_t x, uint32_t y) {
            return reference::StretchedMean(light, (x + 0.5) / 0.3, (y + 0.5) / 0.3, 1 / 0.3, 1 / 0.3, k);
        });
    }
    // Smaller along x, larger along y.
    ASSERT_EQ(folder.Run("resize in.exr -o out.exr --size 20x60 --filter linear").exitCode, 0);
    ExpectTexels(folder, 20, 60, 5e-6, "20x60", [&](uint32_t x, uint32_t y) {
        return reference::StretchedMean(light, (x + 0.5) * 3, (y + 0.5) * 2 / 3, 3, 1, Linear);
    });
    // The cardinal spline, stretched: means under the B-spline, and then what makes a B-spline go through them.
    reference::DoubleImage means{18, 12, {}};
    for (int y = 0; y < 12; y++)
        for (int x = 0; x < 18; x++)
            means.texels.push_back(
                reference::StretchedMean(light, (x + 0.5) / 0.3, (y + 0.5) / 0.3, 1 / 0.3, 1 / 0.3, Cubic));
    means = reference::SplineCoefficients(means);
    ASSERT_EQ(folder.Run("resize in.exr -o out.exr --scale 0.3").exitCode, 0);
    ExpectTexels(folder, 18, 12, 1e-5, "interpolating",
                 [&](uint32_t x, uint32_t y) { return means.At(static_cast<int>(x), static_cast<int>(y)); });
}

TEST(Resize, ByOneIsTheIdentityUnlessTheFilterSmooths) {
    const Folder folder;
    for (const auto& [channels, stored] : {std::pair(3u, SampleType::Unorm8), std::pair(4u, SampleType::Unorm16)}) {
        Picture picture = RandomPicture(33, 20, channels, stored);
        for (size_t i = 3; channels == 4 && i < picture.samples.size(); i += 4)
            picture.samples[i] = 1;
        WritePicture(picture, folder.Path("in.png"), FileFormat::Png, stored);
        for (const char* filter : {"nearest", "linear", "interpolating-bspline", "catmull-rom"}) {
            ASSERT_EQ(folder.Run(fmt::format("resize in.png -o out.png --scale 1 --filter {}", filter)).exitCode, 0);
            EXPECT_EQ(ReadPicture(folder.Path("out.png")).samples, picture.samples) << filter;
        }
        ASSERT_EQ(folder.Run("resize in.png -o out.png --scale 1 --filter bspline").exitCode, 0);
        EXPECT_NE(ReadPicture(folder.Path("out.png")).samples, picture.samples);
    }
}

TEST(Resize, WorksInLinearLightAndKeepsAlpha) {
    const Folder folder;
    // A transparent red column beside an opaque green one: red must not bleed in.
    WritePicture({2, 1, 4, SampleType::Unorm8, {1, 0, 0, 0, 0, 1, 0, 1}}, folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    ASSERT_EQ(folder.Run("resize in.png -o out.png --size 8x1 --filter linear").exitCode, 0);
    const Picture wide = ReadPicture(folder.Path("out.png"));
    EXPECT_EQ(wide.samples[4 * 4 + 0], 0);
    EXPECT_EQ(wide.samples[4 * 4 + 1], 1);
    EXPECT_NEAR(wide.samples[4 * 4 + 3], 0.625, 0.51 / 255);
    // The mean of black and white.
    WritePicture({2, 1, 1, SampleType::Unorm8, {0, 1}}, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    ASSERT_EQ(folder.Run("resize in.png -o out.png --size 1x1").exitCode, 0);
    EXPECT_NEAR(ReadPicture(folder.Path("out.png")).samples[0], ReferenceEncode(0.5), 0.51 / 255);
}

TEST(Derive, IsTheDerivativeOfTheSpline) {
    const Folder folder;
    const auto light = ReferenceLight(WriteFloats(folder, 24, 18), false);
    const auto at = [&](uint32_t x, uint32_t y, int orderX, int orderY) {
        return reference::CubicSum(
            light, x + 0.5, y + 0.5, [=](double d) { return reference::BSplineDerivative(orderX, d); },
            [=](double d) { return reference::BSplineDerivative(orderY, d); });
    };
    const auto curvature = [](double dx, double dy, double dxx, double dxy, double dyy) {
        return -(dxx * dy * dy - 2 * dxy * dx * dy + dyy * dx * dx) / std::pow(dx * dx + dy * dy, 1.5);
    };
    const auto derive = [&](const std::string& what, double tolerance, auto expected) {
        ASSERT_EQ(folder.Run("derive in.exr -o out.exr --what " + what).exitCode, 0);
        ExpectTexels(folder, 24, 18, tolerance, what, expected);
    };
    derive("dx", 1e-6, [&](uint32_t x, uint32_t y) { return at(x, y, 1, 0); });
    derive("dy", 1e-6, [&](uint32_t x, uint32_t y) { return at(x, y, 0, 1); });
    derive("dxx", 2e-6, [&](uint32_t x, uint32_t y) { return at(x, y, 2, 0); });
    derive("dxy", 1e-6, [&](uint32_t x, uint32_t y) { return at(x, y, 1, 1); });
    derive("dyy", 2e-6, [&](uint32_t x, uint32_t y) { return at(x, y, 0, 2); });
    derive("gradient", 1e-6, [&](uint32_t x, uint32_t y) {
        const glm::dvec4 dx = at(x, y, 1, 0), dy = at(x, y, 0, 1);
        return glm::dvec4(glm::sqrt(dx * dx + dy * dy));
    });
    ASSERT_EQ(folder.Run("derive in.exr -o out.exr --what curvature").exitCode, 0);
    const Picture picture = ReadPicture(folder.Path("out.exr"));
    for (uint32_t y = 0; y < 18; y++)
        for (uint32_t x = 0; x < 24; x++)
            for (int c = 0; c < 3; c++) {
                const double expected = curvature(at(x, y, 1, 0)[c], at(x, y, 0, 1)[c], at(x, y, 2, 0)[c],
                                                  at(x, y, 1, 1)[c], at(x, y, 0, 2)[c]);
                ASSERT_NEAR(picture.samples[(y * 24 + x) * 3 + c], expected, 1e-4 * (1 + std::abs(expected)));
            }
}

TEST(Derive, CurvatureOfABrightDiscIsOneByItsRadius) {
    const Folder folder;
    Picture cone{65, 65, 1, SampleType::Float32, {}};
    for (int y = 0; y < 65; y++)
        for (int x = 0; x < 65; x++)
            cone.samples.push_back(40 - static_cast<float>(std::hypot(x - 32, y - 32)));
    WritePicture(cone, folder.Path("in.pfm"), FileFormat::Pfm, SampleType::Float32);
    ASSERT_EQ(folder.Run("derive in.pfm -o out.pfm --what curvature").exitCode, 0);
    const Picture curvature = ReadPicture(folder.Path("out.pfm"));
    for (const int radius : {8, 16, 28})
        EXPECT_NEAR(curvature.samples[static_cast<size_t>(32 * 65 + 32 + radius)] * static_cast<float>(radius), 1,
                    0.01);
}

TEST(Derive, ShowsSignsInIntegersAboutOneHalf) {
    const Folder folder;
    Picture ramp{16, 4, 4, SampleType::Unorm8, {}};
    for (int i = 0; i < 64; i++)
        for (const float sample :
             {static_cast<float>(i % 16) / 255 * 16, 0.5f, 1 - static_cast<float>(i % 16) / 17, 1.0f})
            ramp.samples.push_back(std::round(sample * 255) / 255);
    WritePicture(ramp, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    ASSERT_EQ(folder.Run("derive in.png -o out.png --what dx --transfer raw").exitCode, 0);
    const Picture slope = ReadPicture(folder.Path("out.png"));
    ASSERT_EQ(slope.channels, 3u);
    EXPECT_NEAR(slope.samples[(16 + 8) * 3 + 0], 0.5 + 0.5 * 16 / 255, 0.51 / 255);
    EXPECT_NEAR(slope.samples[(16 + 8) * 3 + 1], 0.5, 0.51 / 255);
    EXPECT_NEAR(slope.samples[(16 + 8) * 3 + 2], 0.5 - 0.5 * 15 / 255, 0.51 / 255);
    ASSERT_EQ(folder.Run("derive in.png -o out.png --what gradient --transfer raw").exitCode, 0);
    EXPECT_NEAR(ReadPicture(folder.Path("out.png")).samples[(16 + 8) * 3 + 0], 16.0 / 255, 0.51 / 255);
}

TEST(Resize, RefusesInOneLine) {
    const Folder folder;
    WritePicture(RandomPicture(8, 8, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const auto refused = [&](const std::string& arguments, int exitCode, const std::string& line) {
        const Outcome outcome = folder.Run(arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments;
        EXPECT_EQ(outcome.err, "boxcar: " + line + "\n");
    };
    refused("resize in.png -o out.png", 2, "resize takes --size WxH or --scale S");
    refused("resize in.png -o out.png --scale 0", 2, "--scale 0: expected a number from 0.0001 to 16384");
    refused("resize in.png -o out.png --scale nan", 2, "--scale nan: expected a number from 0.0001 to 16384");
    refused("resize in.png -o out.png --scale 2 --taps 4", 2, "The following argument was not expected: --taps");
    refused("resize in.png -o out.png --size 4", 2, "--size 4: expected WxH, two whole numbers from 1 to 8192");
    EXPECT_EQ(folder.Run("resize in.png -o out.png --scale 16000").exitCode, 1);
    EXPECT_EQ(folder.Run("resize in.png -o out.png --scale 2 --size 3x3").exitCode, 2);
    EXPECT_EQ(folder.Run("resize in.png -o out.png --scale 2 --filter lanczos").exitCode, 2);
    EXPECT_EQ(folder.Run("derive in.png -o out.exr --what dz").exitCode, 2);
    EXPECT_EQ(folder.Run("derive in.png -o out.exr").exitCode, 2);
    EXPECT_EQ(folder.Names(), (std::vector<std::string>{"in.png"}));
}

}  // namespace
}  // namespace boxcar
