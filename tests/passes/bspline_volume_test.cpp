// The cubic B-spline of volumes against the analytic one in double, and curvatures of surfaces that are known.
#include "tests/reference/bspline_volume.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>

#include "passes_shaders.h"
#include "runtime/passes/bspline_lookup.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/reference/bspline.h"
#include "tests/reference/marschner_lobb.h"
#include "tests/support/device_image.h"
#include "tests/support/offsets.h"
#include "tests/support/spirv_fetches.h"

namespace boxcar {
namespace {

// Whole numbers of 64ths, so that places are exact in float.
constexpr glm::vec3 kOffsets[] = {
    {0, 0, 0}, {0.25f, -0.375f, 0.484375f}, {-0.5f, 0.5f, 0.125f}, {0.4375f, 0.140625f, -0.296875f}};

struct TestVolume {
    Extent2D extent;
    uint32_t depth;
    std::vector<float> voxels;

    reference::VolumeOfDoubles ToDouble() const {
        return {
            {static_cast<int>(extent.widthTexels), static_cast<int>(extent.heightTexels), static_cast<int>(depth)},
            {voxels.begin(), voxels.end()}};
    }
};

TestVolume Noise(Extent2D extent, uint32_t depth) {
    std::mt19937 random(5);
    TestVolume volume{extent, depth, {}};
    for (uint64_t i = 0; i < extent.Texels() * depth; i++)
        volume.voxels.push_back(static_cast<float>(random() % 256) / 255);
    return volume;
}

// A voxel of the result for each of the volume's.
Texels Filtered(const std::string& form, const TestVolume& volume, glm::vec3 offsetTexels,
                glm::vec3 voxelSides = glm::vec3(1)) {
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/bspline_3d.ps.FORM=" + form)});
    const Image source(
        TestDevice(),
        {.extent = volume.extent, .format = Format::R32F, .name = "test volume", .depthTexels = volume.depth});
    WriteTexels(TestDevice(), source, std::as_bytes(std::span(volume.voxels)));
    const Extent2D slices{volume.extent.widthTexels, volume.extent.heightTexels * volume.depth};
    const Image result(TestDevice(), {slices, Format::RGBA32F, form});
    const VolumeConstants constants{offsetTexels, 0, voxelSides};
    BSplineLookup lookup(TestDevice(), {.sizeTexels = 128});
    CommandList commands(TestDevice());
    std::vector<Read> reads = {{"source", &source}};
    if (form == "LOOKUP") reads.push_back({"hg", &lookup.Record(commands)});
    commands.Draw({.name = form,
                   .pipeline = pipeline,
                   .reads = std::move(reads),
                   .writes = {&result},
                   .constants = ConstantBytes(constants)});
    commands.SubmitAndWait();
    return Download(result);
}

// The largest difference of channel c to the sum of voxels times derivatives of the spline of these orders.
double LargestError(const std::string& form, const TestVolume& volume, int channel, std::array<int, 3> orders) {
    double largest = 0;
    for (const glm::vec3 offset : kOffsets) {
        const Texels filtered = Filtered(form, volume, offset);
        std::array<std::function<double(double)>, 3> kernels;
        for (size_t axis = 0; axis < 3; axis++)
            kernels[axis] = [order = orders[axis]](double x) { return reference::BSplineDerivative(order, x); };
        const auto expected = reference::TensorSum(volume.ToDouble(), {offset.x, offset.y, offset.z}, kernels);
        for (size_t i = 0; i < filtered.size(); i++)
            largest = std::max(largest, std::abs(filtered[i][channel] - expected.voxels[i]));
    }
    testing::Test::RecordProperty(fmt::format("{}_{}{}{}", form, orders[0], orders[1], orders[2]),
                                  fmt::format("{:.3g}", largest));
    return largest;
}

TEST(BSplineVolume, ExactWeightsAreTheSpline) {
    const TestVolume noise = Noise({64, 64}, 64);
    EXPECT_LE(LargestError("LOAD", noise, 0, {0, 0, 0}), 5e-7);
    EXPECT_LE(LargestError("LOAD_GRADIENT", noise, 3, {0, 0, 0}), 5e-7);
    EXPECT_LE(LargestError("LOAD_GRADIENT", noise, 0, {1, 0, 0}), 5e-7);
    EXPECT_LE(LargestError("LOAD_GRADIENT", noise, 1, {0, 1, 0}), 5e-7);
    EXPECT_LE(LargestError("LOAD_GRADIENT", noise, 2, {0, 0, 1}), 5e-7);
    EXPECT_LE(LargestError("LOAD_PURE", noise, 0, {2, 0, 0}), 1e-6);
    EXPECT_LE(LargestError("LOAD_PURE", noise, 1, {0, 2, 0}), 1e-6);
    EXPECT_LE(LargestError("LOAD_PURE", noise, 2, {0, 0, 2}), 1e-6);
    EXPECT_LE(LargestError("LOAD_MIXED", noise, 0, {0, 1, 1}), 5e-7);
    EXPECT_LE(LargestError("LOAD_MIXED", noise, 1, {1, 0, 1}), 5e-7);
    EXPECT_LE(LargestError("LOAD_MIXED", noise, 2, {1, 1, 0}), 5e-7);
}

TEST(BSplineVolume, EightFetchesAreNearTheSpline) {
    const TestVolume noise = Noise({64, 64}, 64);
    EXPECT_LE(LargestError("SAMPLE", noise, 0, {0, 0, 0}), 3e-6);
    EXPECT_LE(LargestError("GRADIENT", noise, 0, {1, 0, 0}), 4e-6);
    EXPECT_LE(LargestError("GRADIENT", noise, 1, {0, 1, 0}), 4e-6);
    EXPECT_LE(LargestError("GRADIENT", noise, 2, {0, 0, 1}), 4e-6);
    EXPECT_LE(LargestError("LOOKUP", noise, 0, {0, 0, 0}), 3e-5);
}

TEST(BSplineVolume, HoldsForVolumesOfEveryExtent) {
    for (const auto& [extent, depth] : {std::pair(Extent2D{1, 1}, 1u), std::pair(Extent2D{6, 1}, 3u),
                                        std::pair(Extent2D{2, 19}, 12u), std::pair(Extent2D{5, 4}, 33u)}) {
        const TestVolume noise = Noise(extent, depth);
        EXPECT_LE(LargestError("SAMPLE", noise, 0, {0, 0, 0}), 3e-6);
        EXPECT_LE(LargestError("LOAD", noise, 0, {0, 0, 0}), 5e-7);
        EXPECT_LE(LargestError("LOAD_MIXED", noise, 1, {1, 0, 1}), 5e-7);
    }
}

TEST(BSplineVolume, TakesEightFetchesAValueInsteadOf64) {
    const auto fetches = [](const std::string& form) {
        return FetchesIn(test_support_shaders::Find("shaders/bspline_3d.ps.FORM=" + form).spirv);
    };
    using Counts = std::map<std::string, int>;
    EXPECT_EQ(fetches("SAMPLE"), (Counts{{"source", 8}}));
    EXPECT_EQ(fetches("LOOKUP"), (Counts{{"source", 8}, {"hg", 3}}));
    EXPECT_EQ(fetches("GRADIENT"), (Counts{{"source", 24}}));
    EXPECT_EQ(fetches("LOAD"), (Counts{{"source", 64}}));
    EXPECT_EQ(fetches("LOAD_MIXED"), (Counts{{"source", 64}}));
}

// Curvatures of f = const for a volume sampled from f at voxels whose middle is the origin; `margin` voxels of the
// sides, and places that `counts` does not want, are left out.
struct Curved {
    double worst = 0;  // relative to the largest curvature there
    int places = 0;
};

Curved WorstCurvature(double (*f)(glm::dvec3), std::pair<double, double> (*curvatures)(glm::dvec3),
                      bool (*counts)(glm::dvec3), glm::dvec3 sides) {
    constexpr int kSide = 48, kMargin = 3;
    TestVolume volume{{kSide, kSide}, kSide, {}};
    const auto place = [&](int x, int y, int z) { return (glm::dvec3(x, y, z) + 0.5 - kSide / 2.0) * sides; };
    for (int z = 0; z < kSide; z++)
        for (int y = 0; y < kSide; y++)
            for (int x = 0; x < kSide; x++)
                volume.voxels.push_back(static_cast<float>(f(place(x, y, z))));
    const Texels filtered = Filtered("CURVATURE", volume, glm::vec3(0), sides);
    Curved curved;
    for (int z = kMargin; z < kSide - kMargin; z++)
        for (int y = kMargin; y < kSide - kMargin; y++)
            for (int x = kMargin; x < kSide - kMargin; x++) {
                const glm::dvec3 p = place(x, y, z);
                if (!counts(p)) continue;
                const auto [larger, smaller] = curvatures(p);
                const glm::vec4 found = filtered[static_cast<size_t>((z * kSide + y) * kSide + x)];
                const double scale = std::max(std::abs(larger), std::abs(smaller));
                curved.worst =
                    std::max({curved.worst, std::abs(found.x - larger) / scale, std::abs(found.y - smaller) / scale});
                curved.places++;
            }
    return curved;
}

// Bright inside, sampled from the square of the distance: a polynomial of the second degree, whose gradient and
// Hessian the B-spline keeps.
TEST(BSplineVolume, CurvatureOfBallsAndCylindersIsOneOverTheirRadius) {
    const auto ball = WorstCurvature([](glm::dvec3 p) { return -glm::dot(p, p) / 100; },
                                     [](glm::dvec3 p) { return std::pair(1 / glm::length(p), 1 / glm::length(p)); },
                                     [](glm::dvec3 p) { return glm::length(p) > 4; }, glm::dvec3(1));
    EXPECT_LE(ball.worst, 0.001);
    EXPECT_GT(ball.places, 10000);
    const auto hollow =
        WorstCurvature([](glm::dvec3 p) { return glm::dot(p, p) / 100; },
                       [](glm::dvec3 p) { return std::pair(-1 / glm::length(p), -1 / glm::length(p)); },
                       [](glm::dvec3 p) { return glm::length(p) > 4; }, glm::dvec3(1, 0.5, 2));
    EXPECT_LE(hollow.worst, 0.002);  // half a millimetre: second differences are a quarter as large
    const auto cylinder = WorstCurvature([](glm::dvec3 p) { return -(p.x * p.x + p.z * p.z) / 100; },
                                         [](glm::dvec3 p) { return std::pair(1 / std::hypot(p.x, p.z), 0.0); },
                                         [](glm::dvec3 p) { return std::hypot(p.x, p.z) > 4; }, glm::dvec3(2, 1, 1));
    EXPECT_LE(cylinder.worst, 0.001);
}

// Sampled from the distance itself, the spline smooths it: by a sixth of a voxel squared times its second
// derivatives. From a radius of 8 voxels on that is within 1 %.
TEST(BSplineVolume, CurvatureOfDistancesIsWithinOnePercentFromEightVoxelsOn) {
    const auto ball = WorstCurvature([](glm::dvec3 p) { return -glm::length(p); },
                                     [](glm::dvec3 p) { return std::pair(1 / glm::length(p), 1 / glm::length(p)); },
                                     [](glm::dvec3 p) { return glm::length(p) > 8; }, glm::dvec3(1));
    testing::Test::RecordProperty("ball", fmt::format("{:.4f}", ball.worst));
    EXPECT_LE(ball.worst, 0.01);
    // A ring of radius 14 in the plane z = 0: its tubes' curvatures are 1 / r, and the cosine over the distance from
    // the axis.
    const auto torus = WorstCurvature([](glm::dvec3 p) { return -std::hypot(std::hypot(p.x, p.y) - 14, p.z); },
                                      [](glm::dvec3 p) {
                                          const double axis = std::hypot(p.x, p.y), tube = std::hypot(axis - 14, p.z);
                                          const double round = (axis - 14) / tube / axis;
                                          return std::pair(std::max(1 / tube, round), std::min(1 / tube, round));
                                      },
                                      [](glm::dvec3 p) {
                                          const double axis = std::hypot(p.x, p.y), tube = std::hypot(axis - 14, p.z);
                                          return tube > 8 && tube < 12 && axis > 5;
                                      },
                                      glm::dvec3(1));
    testing::Test::RecordProperty("torus", fmt::format("{:.4f}", torus.worst));
    EXPECT_LE(torus.worst, 0.01);
    EXPECT_GT(torus.places, 1000);
}

// Pieces of the signal, sampled finely: 1024 voxels would go across all of it. As 40 do, as the paper has it, its
// waves are near what voxels can hold, and the spline flattens them.
TEST(BSplineVolume, MeanAndGaussianCurvatureOfTheMarschnerLobbSignalAreTheAnalyticOnes) {
    constexpr int kSide = 48, kMargin = 3;
    constexpr double kVoxel = 2.0 / 1024;
    double worstMean = 0, worstGauss = 0;
    for (const glm::dvec3 middle :
         {glm::dvec3(0.3, 0.2, 0.1), glm::dvec3(-0.5, 0.1, -0.3), glm::dvec3(0.05, -0.8, 0.2)}) {
        TestVolume volume{{kSide, kSide}, kSide, {}};
        const auto place = [&](int x, int y, int z) {
            return middle + (glm::dvec3(x, y, z) + 0.5 - kSide / 2.0) * kVoxel;
        };
        for (int z = 0; z < kSide; z++)
            for (int y = 0; y < kSide; y++)
                for (int x = 0; x < kSide; x++)
                    volume.voxels.push_back(static_cast<float>(reference::MarschnerLobb(place(x, y, z)).value - 0.5));
        const Texels found = Filtered("CURVATURE", volume, glm::vec3(0), glm::vec3(kVoxel));
        for (int z = kMargin; z < kSide - kMargin; z++)
            for (int y = kMargin; y < kSide - kMargin; y++)
                for (int x = kMargin; x < kSide - kMargin; x++) {
                    const reference::MarschnerLobb signal(place(x, y, z));
                    const auto [larger, smaller] = reference::Curvatures(signal.gradient, signal.hessian);
                    const double scale = std::max(std::abs(larger), std::abs(smaller));
                    const glm::dvec4 at(found[static_cast<size_t>((z * kSide + y) * kSide + x)]);
                    worstMean = std::max(worstMean, std::abs(at.x + at.y - larger - smaller) / 2 / scale);
                    worstGauss = std::max(worstGauss, std::abs(at.x * at.y - larger * smaller) / (scale * scale));
                }
    }
    RecordProperty("mean", fmt::format("{:.4f}", worstMean));
    RecordProperty("gauss", fmt::format("{:.4f}", worstGauss));
    EXPECT_LE(worstMean, 0.01);
    EXPECT_LE(worstGauss, 0.01);
}

// Gradient and Hessian in double, and of them the paper's invariants.
TEST(BSplineVolume, CurvatureIsThePapersFormula) {
    const TestVolume noise = Noise({24, 20}, 16);
    const glm::dvec3 sides(1, 0.75, 2);
    const Texels found = Filtered("CURVATURE", noise, {0.25f, -0.375f, 0.125f}, sides);
    const auto derivative = [&](std::array<int, 3> orders) {
        std::array<std::function<double(double)>, 3> kernels;
        for (size_t axis = 0; axis < 3; axis++)
            kernels[axis] = [order = orders[axis]](double x) { return reference::BSplineDerivative(order, x); };
        return reference::TensorSum(noise.ToDouble(), {0.25, -0.375, 0.125}, kernels).voxels;
    };
    const auto dx = derivative({1, 0, 0}), dy = derivative({0, 1, 0}), dz = derivative({0, 0, 1});
    const auto dxx = derivative({2, 0, 0}), dyy = derivative({0, 2, 0}), dzz = derivative({0, 0, 2});
    const auto dyz = derivative({0, 1, 1}), dxz = derivative({1, 0, 1}), dxy = derivative({1, 1, 0});
    for (size_t i = 0; i < found.size(); i++) {
        const glm::dvec3 g = glm::dvec3(dx[i], dy[i], dz[i]) / sides;
        if (glm::length(g) < 0.02) continue;
        glm::dmat3 h(dxx[i], dxy[i], dxz[i], dxy[i], dyy[i], dyz[i], dxz[i], dyz[i], dzz[i]);
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                h[a][b] /= sides[a] * sides[b];
        const auto [larger, smaller] = reference::Curvatures(g, h);
        const double scale = std::max(std::abs(larger), std::abs(smaller));
        ASSERT_NEAR(found[i].x, larger, 1e-4 * scale + 1e-4) << i;
        ASSERT_NEAR(found[i].y, smaller, 1e-4 * scale + 1e-4) << i;
        ASSERT_GE(found[i].x, found[i].y);
    }
}

}  // namespace
}  // namespace boxcar
