// Third-order filters against the analytic spline in double.
#include "tests/reference/bspline.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hlsl/constants/bspline_constants.h"
#include "passes_shaders.h"
#include "runtime/passes/bspline_prefilter.h"
#include "runtime/passes/quad_shaders.h"
#include "runtime/passes/resize.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/support/device_image.h"
#include "tests/support/offsets.h"
#include "tests/support/spirv_fetches.h"

namespace boxcar {
namespace {

constexpr Extent2D kNoiseExtent{256, 256};
// So that points are exact in floats.
constexpr glm::vec2 kOffsets[] = {{0, 0}, {0.25f, -0.375f}, {-0.5f, 0.5f}, {0.4375f, 0.109375f}};

Texels Noise(Extent2D extent, uint32_t seed) {
    Texels texels = RandomCodes(extent, seed);
    for (glm::vec4& texel : texels)
        texel /= 255.0f;
    return texels;
}

Texels Filtered(const std::string& form, Extent2D extent, const Texels& source, glm::vec2 offsetTexels) {
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/bspline_2d.ps.FORM=" + form)});
    const Image result(TestDevice(), {extent, Format::RGBA32F, form});
    const SampleConstants constants{int2(extent.widthTexels, extent.heightTexels), float2(0), offsetTexels};
    return RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
        commands.Draw({.name = form,
                       .pipeline = pipeline,
                       .reads = {{"source", &image}},
                       .writes = {&result},
                       .constants = ConstantBytes(constants)});
        return result;
    });
}

// The largest difference to the sum of texels times kernels.
template <typename KernelX, typename KernelY>
double LargestError(const std::string& form, Extent2D extent, KernelX kernelX, KernelY kernelY) {
    const Texels source = Noise(extent, 7);
    const auto image = ToDouble(extent, source);
    double largest = 0;
    for (const glm::vec2 offset : kOffsets) {
        const Texels filtered = Filtered(form, extent, source, offset);
        for (uint32_t y = 0; y < extent.heightTexels; y++)
            for (uint32_t x = 0; x < extent.widthTexels; x++) {
                const auto expected = reference::CubicSum(image, x + 0.5 + static_cast<double>(offset.x),
                                                          y + 0.5 + static_cast<double>(offset.y), kernelX, kernelY);
                const glm::dvec4 error = glm::dvec4(filtered[y * extent.widthTexels + x]) - expected;
                for (int c = 0; c < 4; c++)
                    largest = std::max(largest, std::abs(error[c]));
            }
    }
    testing::Test::RecordProperty(form, fmt::format("{:.3g}", largest));
    return largest;
}

auto Spline(int order) {
    return [order](double x) { return reference::BSplineDerivative(order, x); };
}

// And so they add up to what the splines' do: 1, 0 and 0.
TEST(BSpline, WeightsAreTheBasisAtTheTexels) {
    constexpr uint32_t kPoints = 256;
    for (int order = 0; order < 3; order++) {
        const Pipeline pipeline(TestDevice(), QuadShaders(fmt::format("bspline_weights.ps.ORDER={}", order)));
        const Image result(TestDevice(), {{kPoints, 1}, Format::RGBA32F, "weights"});
        const BSplineWeightsConstants constants{kPoints};
        CommandList commands(TestDevice());
        commands.Draw(
            {.name = "weights", .pipeline = pipeline, .writes = {&result}, .constants = ConstantBytes(constants)});
        commands.SubmitAndWait();
        const Texels weights = Download(result);
        for (uint32_t i = 0; i < kPoints; i++) {
            const double t = (i + 0.5) / kPoints;
            for (int k = 0; k < 4; k++)
                ASSERT_NEAR(weights[i][k], reference::BSplineDerivative(order, t + 1 - k), 1.5e-7)
                    << order << " " << t;
            ASSERT_NEAR(weights[i].x + weights[i].y + weights[i].z + weights[i].w, order == 0 ? 1 : 0, 2e-7);
        }
    }
}

// For derivatives a jump of the pattern between two texels would count: third derivatives are not asked for.
TEST(BSpline, ExactWeightsAreTheSpline) {
    EXPECT_LE(LargestError("LOAD", kNoiseExtent, Spline(0), Spline(0)), 5e-7);
    EXPECT_LE(LargestError("LOAD_DX", kNoiseExtent, Spline(1), Spline(0)), 5e-7);
    EXPECT_LE(LargestError("LOAD_DY", kNoiseExtent, Spline(0), Spline(1)), 5e-7);
    EXPECT_LE(LargestError("LOAD_DXX", kNoiseExtent, Spline(2), Spline(0)), 1e-6);
    EXPECT_LE(LargestError("LOAD_DXY", kNoiseExtent, Spline(1), Spline(1)), 5e-7);
    EXPECT_LE(LargestError("LOAD_DYY", kNoiseExtent, Spline(0), Spline(2)), 1e-6);
}

TEST(BSpline, FewFetchesAreNearTheSpline) {
    EXPECT_LE(LargestError("SAMPLE", kNoiseExtent, Spline(0), Spline(0)), 1e-5);
    EXPECT_LE(LargestError("SAMPLE_DX", kNoiseExtent, Spline(1), Spline(0)), 1.2e-5);
    EXPECT_LE(LargestError("SAMPLE_DY", kNoiseExtent, Spline(0), Spline(1)), 1.2e-5);
}

TEST(BSpline, FewFetchesAreFew) {
    const auto fetches = [](const std::string& form) {
        return FetchesIn(test_support_shaders::Find("shaders/bspline_2d.ps.FORM=" + form).spirv).at("source");
    };
    EXPECT_EQ(fetches("SAMPLE"), 4);
    EXPECT_EQ(fetches("SAMPLE_DX"), 4);
    EXPECT_EQ(fetches("LOAD"), 16);
    EXPECT_EQ(fetches("CATMULL_SAMPLE"), 9);
    EXPECT_EQ(fetches("CATMULL_LOAD"), 16);
}

TEST(BSpline, CatmullRomIsKeysCubic) {
    EXPECT_LE(LargestError("CATMULL_LOAD", kNoiseExtent, reference::CatmullRom, reference::CatmullRom), 7e-7);
    EXPECT_LE(LargestError("CATMULL_SAMPLE", kNoiseExtent, reference::CatmullRom, reference::CatmullRom), 1.5e-5);
    for (const Extent2D extent : {Extent2D{1, 6}, Extent2D{6, 1}, Extent2D{12, 19}})
        EXPECT_LE(LargestError("CATMULL_LOAD", extent, reference::CatmullRom, reference::CatmullRom), 7e-7);
}

// A spline of a cubic's texels, after the prefilter of all of them, is the cubic: here by hand, a polynomial's second
// difference is taken off: texels of x^2 make the spline x^2 + 1/3, of x^3 x^3 + x.
TEST(BSpline, DerivativesOfPolynomialsAreExact) {
    constexpr Extent2D kExtent{24, 20};
    Texels texels;
    for (uint32_t y = 0; y < 20; y++)
        for (uint32_t x = 0; x < 24; x++) {
            const float u = static_cast<float>(x) - 12, v = static_cast<float>(y) - 10;
            texels.emplace_back(1, u * v, u * u * u - u, v * v);
        }
    const glm::vec2 offset{0.25f, -0.5f};
    const auto inside = [&](const std::string& form, auto expected, double tolerance) {
        const Texels filtered = Filtered(form, kExtent, texels, offset);
        for (uint32_t y = 3; y < 17; y++)
            for (uint32_t x = 3; x < 21; x++) {
                const double u = x + 0.25 - 12, v = y - 0.5 - 10;
                const glm::dvec4 should = expected(u, v);
                for (int c = 0; c < 4; c++)
                    ASSERT_NEAR(filtered[y * 24 + x][c], should[c], tolerance) << form << " " << c;
            }
    };
    inside(
        "LOAD", [](double u, double v) { return glm::dvec4(1, u * v, u * u * u, v * v + 1 / 3.0); }, 2e-4);
    inside(
        "LOAD_DX", [](double u, double v) { return glm::dvec4(0, v, 3 * u * u, 0); }, 2e-4);
    inside(
        "LOAD_DY", [](double u, double v) { return glm::dvec4(0, u, 0, 2 * v); }, 2e-4);
    inside(
        "LOAD_DXX", [](double u, double) { return glm::dvec4(0, 0, 6 * u, 0); }, 2e-4);
    inside(
        "LOAD_DXY", [](double, double) { return glm::dvec4(0, 1, 0, 0); }, 2e-4);
    inside(
        "LOAD_DYY", [](double, double) { return glm::dvec4(0, 0, 0, 2); }, 2e-4);
}

TEST(BSplinePrefilter, IsTheSolutionOfTheLinesAndTheSplineGoesThroughTheTexels) {
    for (const Extent2D extent : {Extent2D{1, 1}, Extent2D{2, 3}, Extent2D{19, 12}, Extent2D{100, 70}}) {
        const Texels source = Noise(extent, 3);
        BSplinePrefilter alongX(TestDevice(), extent, Axis::X), alongY(TestDevice(), extent, Axis::Y);
        const Texels coefficients =
            RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
                return alongY.Record(commands, alongX.Record(commands, image));
            });
        const auto expected = reference::SplineCoefficients(ToDouble(extent, source));
        for (size_t i = 0; i < source.size(); i++)
            for (int c = 0; c < 4; c++)
                ASSERT_NEAR(coefficients[i][c], expected.texels[i][c], 2e-6)
                    << extent.widthTexels << " x " << extent.heightTexels;
        const Texels spline = Filtered("LOAD", extent, coefficients, {0, 0});
        for (size_t i = 0; i < source.size(); i++)
            for (int c = 0; c < 4; c++)
                ASSERT_NEAR(spline[i][c], source[i][c], 1e-5);
    }
}

TEST(Resize, ReadsTheSourceWhereItSays) {
    constexpr Extent2D kSource{20, 14}, kResult{53, 61};
    const Texels source = Noise(kSource, 11);
    const auto image = ToDouble(kSource, source);
    const std::pair<ResizeFilter, double (*)(double)> filters[] = {
        {ResizeFilter::Linear, [](double x) { return reference::BSpline(1, x); }},
        {ResizeFilter::BSpline, [](double x) { return reference::BSpline(3, x); }},
        {ResizeFilter::CatmullRom, reference::CatmullRom}};
    for (const auto& [filter, kernel] : filters) {
        Resize resize(TestDevice(), {kSource, kResult, {20 / 53.0f, 14 / 61.0f}, filter});
        const Texels result =
            RunOnDevice(kSource, source, [&](CommandList& commands, const Image& texels) -> const Image& {
                return resize.Record(commands, texels);
            });
        for (uint32_t y = 0; y < kResult.heightTexels; y++)
            for (uint32_t x = 0; x < kResult.widthTexels; x++) {
                const auto expected =
                    reference::CubicSum(image, (x + 0.5) * 20 / 53, (y + 0.5) * 14 / 61, kernel, kernel);
                for (int c = 0; c < 4; c++)
                    ASSERT_NEAR(result[y * 53 + x][c], expected[c], 1e-5) << static_cast<int>(filter);
            }
    }
}

// The share of a zone plate's contrast that a quarter of it keeps where it cannot hold the rings.
TEST(Resize, SmallerPicturesDoNotAlias) {
    constexpr Extent2D kSource{256, 256}, kResult{64, 64};
    Texels plate;
    for (int y = 0; y < 256; y++)
        for (int x = 0; x < 256; x++) {
            const double r2 = (x - 127.5) * (x - 127.5) + (y - 127.5) * (y - 127.5);
            plate.emplace_back(0.5 + 0.5 * std::cos(r2 * 3.14159265 / 256));
        }
    const std::tuple<const char*, ResizeFilter, double, double> filters[] = {
        {"nearest", ResizeFilter::Nearest, 0.9, 1.1},
        {"linear", ResizeFilter::Linear, 0, 0.02},
        {"bspline", ResizeFilter::BSpline, 0, 0.002},
        {"catmull-rom", ResizeFilter::CatmullRom, 0, 0.006},
        {"interpolating-bspline", ResizeFilter::InterpolatingBSpline, 0, 0.005}};
    for (const auto& [name, filter, low, high] : filters) {
        Resize resize(TestDevice(), {kSource, kResult, float2(4), filter});
        const Texels texels =
            RunOnDevice(kSource, plate, [&](CommandList& commands, const Image& image) -> const Image& {
                return resize.Record(commands, image);
            });
        double sum = 0;
        int count = 0;
        // The result holds rings up to 8 of its texels from the middle; beyond 20 all are far finer.
        for (int y = 0; y < 64; y++)
            for (int x = 0; x < 64; x++) {
                const double r = std::hypot(x - 31.5, y - 31.5);
                if (r < 20 || r > 29) continue;
                sum += std::pow(texels[static_cast<size_t>(y * 64 + x)].x - 0.5, 2);
                count++;
            }
        const double left = std::sqrt(sum / count) / std::sqrt(0.125);
        RecordProperty(name, fmt::format("{:.4f}", left));
        EXPECT_GE(left, low) << name;
        EXPECT_LE(left, high) << name;
    }
}

TEST(Resize, OffsetsInCppEqualThoseInTheShaders) {
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/resize.ps.FILTER=LINEAR")),
              (Offsets{OFFSET(ResizeConstants, stepTexels), OFFSET(ResizeConstants, alongX)}));
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/bspline_weights.ps.ORDER=0")),
              (Offsets{OFFSET(BSplineWeightsConstants, points)}));
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/bspline_prefilter.ps")),
              (Offsets{OFFSET(BSplinePrefilterConstants, stepTexels)}));
}

}  // namespace
}  // namespace boxcar
