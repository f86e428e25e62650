// Third-order filters by fetches, with the kernel from arithmetic and from lookup textures, against sums over texels
// in double. The numbers in docs/third-order.md are the properties that these tests record.
#include "runtime/passes/bspline_lookup.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/packing.hpp>
#include <glm/packing.hpp>

#include "hlsl/constants/bspline_constants.h"
#include "passes_shaders.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/reference/bspline.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"
#include "tests/support/offsets.h"
#include "tests/support/spirv_fetches.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtent{256, 256};
constexpr double kRounding = 6e-8;

using Kernel = std::function<double(double)>;

Kernel Spline(int order) {
    return [order](double x) { return reference::BSplineDerivative(order, x); };
}

Kernel Degree(int degree) {
    return [degree](double x) { return reference::BSpline(degree, x); };
}

// Of four texels, adding up to 1.
Kernel Gauss(double sigmaTexels) {
    return [sigmaTexels](double x) {
        const auto gauss = [&](double d) { return std::exp(-0.5 * d * d / (sigmaTexels * sigmaTexels)); };
        const double t = x - std::floor(x);
        const double sum = gauss(t + 1) + gauss(t) + gauss(t - 1) + gauss(t - 2);
        return x >= -2 && x < 2 ? gauss(x) / sum : 0;
    };
}

Kernel GaussSlope(double sigmaTexels) {
    return [gauss = Gauss(sigmaTexels)](double x) {
        // From one side at t = 0 and 1: beyond are four other texels.
        constexpr double kStep = 1e-5;
        const double t = x - std::floor(x);
        const double lo = std::max(t - kStep, 0.0), hi = std::min(t + kStep, 1 - 1e-12);
        return (gauss(std::floor(x) + hi) - gauss(std::floor(x) + lo)) / (hi - lo);
    };
}

Texels Noise() {
    Texels texels = RandomCodes(kExtent, 7);
    for (glm::vec4& texel : texels)
        texel /= 255.0f;
    return texels;
}

// Points a little less than a texel apart, from before the first texel's centre on. They are exact in float, and so
// is their uv; t goes through 0 to 1 and meets the entries of no lookup texture.
FetchConstants Points() {
    return {.extentTexels = {256, 256},
            .startTexels = {0.25, 0.125},
            .stepTexels = {1 - 391 / 65536.0f, 1 - 613 / 65536.0f},
            .lookupTexels = 128,
            .degree = 3,
            .sigmaTexels = 0.5f};
}

// The same along x; on the middles of rows.
FetchConstants PointsOfLines() {
    FetchConstants points = Points();
    points.startTexels.y = 0.5f;
    points.stepTexels.y = 1;
    return points;
}

// A texture of the source in another format.
Image InFormat(Format format, const Texels& texels) {
    Image image(TestDevice(), {kExtent, format, "source"});
    std::vector<std::byte> bytes;
    const auto append = [&](const auto& value) {
        const auto* first = reinterpret_cast<const std::byte*>(&value);
        bytes.insert(bytes.end(), first, first + sizeof(value));
    };
    for (const glm::vec4& texel : texels) {
        if (format == Format::RGBA8) append(glm::packUnorm4x8(texel));
        if (format == Format::RGBA16F) append(glm::packHalf4x16(texel));
        if (format == Format::RGBA32F) append(texel);
    }
    WriteTexels(TestDevice(), image, bytes);
    return image;
}

// Holds the pipelines of the forms, the source in float32 and the lookup textures that are not under test.
class Bench {
public:
    Bench()
        : m_texels(Noise()),
          m_source(Upload(kExtent, m_texels)),
          m_result(TestDevice(), {kExtent, Format::RGBA32F, "result"}),
          m_value(TestDevice(), {}),
          m_first(TestDevice(), {.kernel = BSplineKernel::FirstDerivative}) {}

    const Texels& SourceTexels() const { return m_texels; }

    struct Options {
        FetchConstants constants = Points();
        const Image* source = nullptr;         // the noise if none is given
        const Image* lookup = nullptr;         // 128 texels of the value, in float32
        BSplineLookup* makesLookup = nullptr;  // instead of one
        BSplineLookup* makesFirst = nullptr;   // 128 texels of the first derivative, in float32, if not given
    };

    Texels Filtered(const std::string& form, const Options& options) {
        if (!m_pipelines.contains(form))
            m_pipelines.emplace(
                form, Pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                              test_support_shaders::Find("shaders/bspline_fetch.ps.FORM=" + form)}));
        CommandList commands(TestDevice());
        const Image* lookup = options.lookup;
        if (!lookup) lookup = &(options.makesLookup ? *options.makesLookup : m_value).Record(commands);
        commands.Draw({.name = form,
                       .pipeline = m_pipelines.at(form),
                       .reads = {{"source", options.source ? options.source : &m_source},
                                 {"hg", lookup},
                                 {"hg1", &(options.makesFirst ? *options.makesFirst : m_first).Record(commands)}},
                       .writes = {&m_result},
                       .constants = ConstantBytes(options.constants)});
        commands.SubmitAndWait();
        return Download(m_result);
    }

    // What the sum of texels times kernels is at the points.
    std::vector<glm::dvec4> Expected(const FetchConstants& points, const Kernel& kernelX,
                                     const Kernel& kernelY) const {
        constexpr int kReach = 3, kTaps = 2 * kReach + 1;
        struct Place {
            int first;
            double weights[kTaps];
        };
        const auto places = [](int count, double start, double step, const Kernel& kernel) {
            std::vector<Place> all;
            for (int i = 0; i < count; i++) {
                const double at = start + step * i;
                Place place{static_cast<int>(std::floor(at)) - kReach, {}};
                for (int tap = 0; tap < kTaps; tap++)
                    place.weights[tap] = kernel(at - (place.first + tap + 0.5));
                all.push_back(place);
            }
            return all;
        };
        const auto columns = places(256, points.startTexels.x, points.stepTexels.x, kernelX);
        const auto rows = places(256, points.startTexels.y, points.stepTexels.y, kernelY);
        std::vector<glm::dvec4> expected;
        for (const Place& row : rows)
            for (const Place& column : columns) {
                glm::dvec4 sum(0);
                for (int j = 0; j < kTaps; j++)
                    for (int i = 0; i < kTaps; i++) {
                        const double weight = row.weights[j] * column.weights[i];
                        if (weight == 0) continue;
                        const int x = std::clamp(column.first + i, 0, 255), y = std::clamp(row.first + j, 0, 255);
                        sum += weight * glm::dvec4(m_texels[static_cast<size_t>(y * 256 + x)]);
                    }
                expected.push_back(sum);
            }
        return expected;
    }

    double LargestError(const std::string& name, const std::string& form, const std::vector<glm::dvec4>& expected,
                        const Options& options) {
        const Texels filtered = Filtered(form, options);
        double largest = 0;
        for (size_t i = 0; i < expected.size(); i++)
            for (int c = 0; c < 4; c++)
                largest = std::max(largest, std::abs(static_cast<double>(filtered[i][c]) - expected[i][c]));
        testing::Test::RecordProperty(name, fmt::format("{:.3g}", largest));
        return largest;
    }

    double LargestError(const std::string& form, const Kernel& kernelX, const Kernel& kernelY) {
        return LargestError(form, form, Expected(Points(), kernelX, kernelY), {});
    }

private:
    Texels m_texels;
    Image m_source, m_result;
    BSplineLookup m_value, m_first;
    std::map<std::string, Pipeline> m_pipelines;
};

// What a form gives at t = 0, 1/256 .. 255/256.
Texels AlongT(const std::string& form, int degree = 3) {
    FetchConstants constants = Points();
    constants.startTexels = {0, 0};
    constants.stepTexels = {1 / 256.0f, 0};
    constants.degree = degree;
    Texels values = Bench().Filtered(form, {.constants = constants});
    values.resize(256);
    return values;
}

TEST(BSplineWeights, OfDegreesZeroAndOneAreNearestAndLinear) {
    for (const int degree : {0, 1, 3}) {
        const Texels weights = AlongT("DEGREE_WEIGHTS", degree);
        for (int i = 0; i < 256; i++)
            for (int texel = 0; texel < 4; texel++)
                ASSERT_NEAR(weights[i][texel], reference::BSpline(degree, i / 256.0 + 1 - texel), 3 * kRounding)
                    << degree << " at " << i;
    }
}

// w0 f0 + w1 f1 is (w0 + w1) times the linear fetch w1 / (w0 + w1) of the way from f0 to f1.
TEST(BSplineWeights, TwoTexelsAreOneFetch) {
    for (const int order : {0, 1}) {
        const Texels hg = AlongT(order == 0 ? "HG" : "HG1");
        for (int i = 0; i < 256; i++) {
            const double t = i / 256.0;
            double w[4];
            for (int texel = 0; texel < 4; texel++)
                w[texel] = reference::BSplineDerivative(order, t + 1 - texel);
            ASSERT_NEAR(hg[i].x, 1 - w[1] / (w[0] + w[1]) + t, 5 * kRounding);
            ASSERT_NEAR(hg[i].y, 1 + w[3] / (w[2] + w[3]) - t, 5 * kRounding);
            ASSERT_NEAR(hg[i].z, w[2] + w[3], 3 * kRounding);
            for (int c = 0; c < 3; c++) {
                ASSERT_GE(hg[i][c], 0) << "RGBA8 does not hold it";
                ASSERT_LE(hg[i][c], 1) << "RGBA8 does not hold it";
            }
        }
    }
}

TEST(BSplineFetch, LinesAreNearTheSpline) {
    Bench bench;
    const FetchConstants points = PointsOfLines();
    const auto error = [&](const std::string& form, int order) {
        return bench.LargestError(form, form, bench.Expected(points, Spline(order), Degree(1)),
                                  {.constants = points});
    };
    EXPECT_LE(error("LINE", 0), 1e-5);
    EXPECT_LE(error("LINE_DX", 1), 1.2e-5);
    EXPECT_LE(error("LINE_DXX", 2), 2.5e-5);
    EXPECT_LE(error("LOOKUP_LINE", 0), 3e-5);
}

TEST(BSplineFetch, PicturesAreNearTheSpline) {
    EXPECT_LE(Bench().LargestError("ARITHMETIC", Spline(0), Spline(0)), 1e-5);
}

TEST(BSplineFetch, SecondDerivativesAreNearTheSpline) {
    Bench bench;
    EXPECT_LE(bench.LargestError("DXX", Spline(2), Spline(0)), 2.5e-5);
    EXPECT_LE(bench.LargestError("DXY", Spline(1), Spline(1)), 2.5e-5);
    EXPECT_LE(bench.LargestError("DYY", Spline(0), Spline(2)), 2.5e-5);
}

TEST(BSplineFetch, OneShaderTakesEveryDegree) {
    Bench bench;
    for (const auto& [degree, bound] : {std::pair(0, 1e-6), std::pair(1, 1e-5), std::pair(3, 1e-5)}) {
        FetchConstants points = Points();
        points.degree = degree;
        EXPECT_LE(bench.LargestError(fmt::format("degree_{}", degree), "DEGREE",
                                     bench.Expected(points, Degree(degree), Degree(degree)), {.constants = points}),
                  bound);
    }
}

// Of four texels, adding up to 1, and the derivative of their sum.
TEST(BSplineFetch, AGaussianIsAnotherKernelInTheSameShader) {
    Bench bench;
    for (const float sigmaTexels : {0.4f, 0.5f, 0.8f}) {
        FetchConstants points = Points();
        points.sigmaTexels = sigmaTexels;
        const std::string sigma = fmt::format("{:.1f}", sigmaTexels);
        const auto value = bench.Expected(points, Gauss(sigmaTexels), Gauss(sigmaTexels));
        EXPECT_LE(bench.LargestError("gauss_" + sigma, "GAUSS", value, {.constants = points}), 1.5e-5);

        BSplineLookup lookup(TestDevice(), {.kernel = BSplineKernel::Gaussian, .sigmaTexels = sigmaTexels});
        Bench::Options options{.constants = points, .makesLookup = &lookup};
        EXPECT_LE(bench.LargestError("gauss_lookup_" + sigma, "LOOKUP", value, options), 6e-5);

        BSplineLookup first(TestDevice(),
                            {.kernel = BSplineKernel::GaussianFirstDerivative, .sigmaTexels = sigmaTexels});
        options.makesFirst = &first;
        const auto slope = bench.Expected(points, GaussSlope(sigmaTexels), Gauss(sigmaTexels));
        EXPECT_LE(bench.LargestError("gauss_lookup_dx_" + sigma, "LOOKUP_DX", slope, options), 5e-4);
    }
}

TEST(BSplineFetch, CountsAreTwoAndFourAgainstSixteen) {
    const auto fetches = [](const std::string& form) {
        return FetchesIn(test_support_shaders::Find("shaders/bspline_fetch.ps.FORM=" + form).spirv);
    };
    using Counts = std::map<std::string, int>;
    EXPECT_EQ(fetches("LINE"), (Counts{{"source", 2}}));
    EXPECT_EQ(fetches("LINE_DX"), (Counts{{"source", 2}}));
    EXPECT_EQ(fetches("LINE_DXX"), (Counts{{"source", 3}}));
    EXPECT_EQ(fetches("ARITHMETIC"), (Counts{{"source", 4}}));
    EXPECT_EQ(fetches("LOAD"), (Counts{{"source", 16}}));
    EXPECT_EQ(fetches("DXX"), (Counts{{"source", 6}}));
    EXPECT_EQ(fetches("DXY"), (Counts{{"source", 4}}));
    EXPECT_EQ(fetches("DYY"), (Counts{{"source", 6}}));
    EXPECT_EQ(fetches("LOOKUP_LINE"), (Counts{{"source", 2}, {"hg", 1}}));
    EXPECT_EQ(fetches("LOOKUP"), (Counts{{"source", 4}, {"hg", 2}}));
    EXPECT_EQ(fetches("LOOKUP_DX"), (Counts{{"source", 4}, {"hg", 1}, {"hg1", 1}}));
}

TEST(BSplineLookup, SizesAndFormats) {
    Bench bench;
    const auto expected = bench.Expected(Points(), Spline(0), Spline(0));
    std::map<Format, std::map<int, double>> linear, nearest;
    for (const Format format : {Format::RGBA32F, Format::RGBA16F, Format::RGBA8})
        for (const int size : {16, 32, 64, 128, 256}) {
            BSplineLookup lookup(TestDevice(), {.sizeTexels = static_cast<uint32_t>(size), .format = format});
            Bench::Options options{.makesLookup = &lookup};
            options.constants.lookupTexels = size;
            const std::string name = fmt::format("{}_{}", FormatName(format), size);
            linear[format][size] = bench.LargestError(name, "LOOKUP", expected, options);
            nearest[format][size] = bench.LargestError(name + "_nearest", "LOOKUP_NEAREST", expected, options);
        }
    auto& full = linear[Format::RGBA32F];
    EXPECT_LE(full[64], 8e-5);
    EXPECT_LE(full[128], 3e-5);
    EXPECT_LE(full[256], 1.5e-5);
    // Linear interpolation of a smooth function errs by the square of the step, the nearest entry by the step.
    EXPECT_NEAR(full[16] / full[32], 4, 1);
    EXPECT_NEAR(full[32] / full[64], 4, 1);
    EXPECT_NEAR(nearest[Format::RGBA32F][32] / nearest[Format::RGBA32F][64], 2, 0.5);
    EXPECT_GT(nearest[Format::RGBA32F][256], full[16]);
    // Half floats hold no more than some 64 entries are worth; 8 bits are of no use at any size.
    for (const int size : {64, 128, 256}) {
        EXPECT_LE(linear[Format::RGBA16F][size], 1e-3);
        EXPECT_GE(linear[Format::RGBA16F][size], 2e-4);
        EXPECT_GE(linear[Format::RGBA8][size], 1e-3);
        EXPECT_LE(linear[Format::RGBA8][size], 1e-2);
    }
}

// A lookup texture with t at its texel centres, (j + 0.5) / size, as a plain table would have it.
Image PlainLookup(int size) {
    Texels texels;
    for (int j = 0; j < size; j++) {
        const double t = (j + 0.5) / size;
        double w[4];
        for (int texel = 0; texel < 4; texel++)
            w[texel] = reference::BSpline(3, t + 1 - texel);
        texels.emplace_back(1 - w[1] / (w[0] + w[1]) + t, 1 + w[3] / (w[2] + w[3]) - t, w[2] + w[3], 1);
    }
    return Upload({static_cast<uint32_t>(size), 1}, texels);
}

TEST(BSplineLookup, EndPointsBelongOnTheFirstAndTheLastTexel) {
    Bench bench;
    const auto expected = bench.Expected(Points(), Spline(0), Spline(0));
    for (const int size : {64, 128}) {
        const Image lookup = PlainLookup(size);
        Bench::Options options{.lookup = &lookup};
        const double error = bench.LargestError(fmt::format("plain_{}", size), "LOOKUP_PLAIN", expected, options);
        EXPECT_GE(error, 0.1 / size) << "flat over half a texel at either end";
        EXPECT_LE(error, 1.0 / size);
    }
}

// Sigg 2005, erratum: the chapter's texture repeats.
TEST(BSplineLookup, ARepeatedTextureBlursTheJump) {
    Bench bench;
    const auto expected = bench.Expected(Points(), Spline(0), Spline(0));
    const Image lookup = PlainLookup(128);
    EXPECT_GE(bench.LargestError("repeat_128", "LOOKUP_REPEAT", expected, {.lookup = &lookup}), 0.05);
}

TEST(BSplineLookup, DerivativesAreNearTheSplines) {
    Bench bench;
    EXPECT_LE(bench.LargestError("LOOKUP_DX", Spline(1), Spline(0)), 1e-4);
    EXPECT_LE(bench.LargestError("LOOKUP_DY", Spline(0), Spline(1)), 1e-4);
}

// Sigg 2005, erratum: in listing 20-1 .z is the second fetch's share, in listing 20-3 the first one's. With one
// meaning the printed difference is the derivative upside down.
TEST(BSplineLookup, TheListingsShareIsTheFirstFetchs) {
    Bench bench;
    const FetchConstants points = PointsOfLines();
    auto expected = bench.Expected(points, Spline(1), Degree(1));
    EXPECT_GE(bench.LargestError("listing_as_printed", "LISTING_DX", expected, {.constants = points}), 0.5);
    for (glm::dvec4& value : expected)
        value = -value;
    EXPECT_LE(bench.LargestError("listing_turned", "LISTING_DX", expected, {.constants = points}), 1e-4);
}

// What is lost where the source has few bits, or where the sampler's weights have 8: an 8-bit format has both.
TEST(BSplineLookup, SourcesOfFewBits) {
    Bench bench;
    const auto value = bench.Expected(Points(), Spline(0), Spline(0));
    const auto second = bench.Expected(Points(), Spline(2), Spline(0));
    std::map<std::pair<std::string, Format>, double> errors;
    for (const Format format : {Format::RGBA8, Format::RGBA16F, Format::RGBA32F}) {
        const Image source = InFormat(format, bench.SourceTexels());
        for (const std::string form : {"ARITHMETIC", "LOAD", "DXX"})
            errors[{form, format}] = bench.LargestError(fmt::format("{}_{}", form, FormatName(format)), form,
                                                        form == "DXX" ? second : value, {.source = &source});
    }
    EXPECT_LE((errors[{"LOAD", Format::RGBA8}]), 5e-7) << "weights of floats, texels that are 8-bit codes";
    EXPECT_LE((errors[{"LOAD", Format::RGBA32F}]), 5e-7);
    EXPECT_LE((errors[{"ARITHMETIC", Format::RGBA32F}]), 1e-5);
    EXPECT_LE((errors[{"ARITHMETIC", Format::RGBA16F}]), 5e-4) << "a half float's rounding";
    // A device may do better than lavapipe, whose weights of 8-bit formats have 8 bits.
    EXPECT_LE((errors[{"ARITHMETIC", Format::RGBA8}]), 1e-2);
    EXPECT_LE((errors[{"DXX", Format::RGBA8}]), 3e-2);
}

TEST(BSplineLookup, RefusesWhatItDoesNotHold) {
    BSplineLookupDesc desc{.sizeTexels = 1};
    EXPECT_ERROR(BSplineLookup(TestDevice(), desc),
                 "a lookup texture of 1 texels: at least 2, for both ends of a kernel");
    desc = {.kernel = BSplineKernel::Gaussian, .sigmaTexels = 2};
    EXPECT_ERROR(BSplineLookup(TestDevice(), desc), "a Gaussian of sigma 2 texels: 0.3 to 0.8 fit into four texels");
    desc = {.kernel = BSplineKernel::Gaussian, .format = Format::RGBA8};
    EXPECT_ERROR(BSplineLookup(TestDevice(), desc),
                 "the lookup texture of a Gaussian in RGBA8: its offsets are over 1; take RGBA16F or RGBA32F");
}

TEST(BSplineLookup, OffsetsInCppEqualThoseInTheShaders) {
    const Offsets table = {OFFSET(BSplineLookupConstants, sizeTexels), OFFSET(BSplineLookupConstants, sigmaTexels)};
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/bspline_lookup.ps.KERNEL=GAUSS")), table);
}

}  // namespace
}  // namespace boxcar
