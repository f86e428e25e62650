// Rays through volumes: where they end, and what does not change that.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>

#include "effects_shaders.h"
#include "hlsl/constants/isosurface_constants.h"
#include "tests/effects/effect_pictures.h"
#include "tests/reference/bspline.h"
#include "tests/reference/marschner_lobb.h"
#include "tests/support/compare_pictures.h"
#include "tests/support/offsets.h"

namespace boxcar {
namespace {

constexpr double kViewRadians = 0.45;  // of the effect's eye, from the lower to the upper rim

Volume VolumeOf(uint32_t side, glm::vec3 millimetres, const std::function<double(glm::dvec3)>& f) {
    Volume volume{side, side, side, millimetres, {}};
    for (uint32_t z = 0; z < side; z++)
        for (uint32_t y = 0; y < side; y++)
            for (uint32_t x = 0; x < side; x++)
                volume.voxels.push_back(static_cast<float>(f((glm::dvec3(x, y, z) + 0.5) * glm::dvec3(millimetres))));
    return volume;
}

struct Shot {
    Texels points, picture;
    double milliseconds = 0;
};

Shot Shoot(const Volume& volume, Extent2D extent, const Settings& settings) {
    const EffectInfo& info = FindEffect("isosurface");
    ParameterValues values(info.parameters);
    for (const auto& [name, value] : settings)
        values.Set(name, value);
    const auto effect = info.make(TestDevice(), {.extent = extent, .volume = volume}, values);
    CommandList commands(TestDevice(), CommandList::Timing::On);
    const Image& picture = effect->Record(commands, {0, values});
    commands.SubmitAndWait();
    Shot shot{Download(*effect->Stages()[0].image), Download(picture)};
    for (const PassTime& pass : commands.PassTimes())
        shot.milliseconds += pass.milliseconds;
    return shot;
}

// The spline of x^2 is x^2 and a third of a voxel's square, on every axis: so the ball's radius under it is known.
TEST(Isosurface, PointsOfABallLieOnItWhateverTheVoxelsSides) {
    for (const glm::vec3 sides : {glm::vec3(1), glm::vec3(1, 0.5f, 2)}) {
        const glm::dvec3 middle = 16.0 * glm::dvec3(sides);
        const Volume volume = VolumeOf(32, sides, [&](glm::dvec3 p) { return -glm::dot(p - middle, p - middle); });
        const double radius = std::sqrt(36 - glm::dot(glm::dvec3(sides), glm::dvec3(sides)) / 3);
        const Shot shot = Shoot(volume, {96, 64}, {{"iso", "-36"}, {"turn", "30"}});
        int hits = 0;
        for (const glm::vec4 point : shot.points) {
            if (point.w != 1) continue;
            EXPECT_NEAR(glm::length(glm::dvec3(point) * glm::dvec3(sides) - middle), radius, 2e-4);
            hits++;
        }
        EXPECT_GT(hits, 150);
    }
}

// A ball, of which every point is seen in the world where a pinhole sees it, and has the world's normal as its
// colour.
TEST(Isosurface, VolumesThatAreTurnedAreSeenFromWhereTheWorldIsSeenFrom) {
    constexpr double kTurn = 0.6, kRise = 0.35;  // radians
    constexpr Extent2D kExtent{192, 128};
    const glm::dvec3 sides(1, 0.5, 2), middle = 16.0 * sides;
    // A bright voxel at each corner, so that the eye sees the whole volume.
    Volume volume = VolumeOf(32, sides, [&](glm::dvec3 p) {
        const bool isCorner = glm::all(glm::greaterThan(glm::abs(p / sides - 16.0), glm::dvec3(15)));
        return isCorner ? 0 : -glm::dot(p - middle, p - middle);
    });
    const double distance = glm::length(middle) / std::sin(kViewRadians / 2);
    const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, -2, 3))));
    volume.worldFromAxes = turn;
    const Shot shot = Shoot(volume, kExtent,
                            {{"iso", "-36"},
                             {"turn", fmt::format("{}", glm::degrees(kTurn))},
                             {"elevation", fmt::format("{}", glm::degrees(kRise))},
                             {"shade", "normal"}});
    const glm::dvec3 toEye(std::sin(kTurn) * std::cos(kRise), std::cos(kTurn) * std::cos(kRise), std::sin(kRise));
    const glm::dvec3 right(-std::cos(kTurn), std::sin(kTurn), 0), up = glm::cross(toEye, right);
    int hits = 0;
    for (uint32_t y = 0; y < kExtent.heightTexels; y++)
        for (uint32_t x = 0; x < kExtent.widthTexels; x++) {
            const size_t at = y * kExtent.widthTexels + x;
            if (shot.points[at].w != 1) continue;
            const glm::dvec3 world = turn * (glm::dvec3(shot.points[at]) * sides - middle);
            const double rim = std::tan(kViewRadians / 2) / (kExtent.heightTexels / 2.0);
            const double u = (x + 0.5 - kExtent.widthTexels / 2.0) * rim;
            const double v = (kExtent.heightTexels / 2.0 - y - 0.5) * rim;
            EXPECT_NEAR(glm::dot(world, right), u * (distance - glm::dot(world, toEye)), 0.003);
            EXPECT_NEAR(glm::dot(world, up), v * (distance - glm::dot(world, toEye)), 0.003);
            for (int c = 0; c < 3; c++)
                EXPECT_NEAR(shot.picture[at][c], 0.5 + 0.5 * glm::normalize(world)[c], 0.002);
            hits++;
        }
    EXPECT_GT(hits, 250);
}

// Every step in double, no block passed over.
TEST(Isosurface, BlocksThatArePassedOverChangeNoPoint) {
    constexpr int kSide = 22;
    constexpr Extent2D kExtent{40, 30};
    std::mt19937 random(3);
    // Mostly empty: single bright voxels among dark ones, and one at each corner, so that the eye sees the whole
    // volume.
    const Volume volume = VolumeOf(kSide, glm::vec3(1), [&](glm::dvec3 p) {
        const bool isCorner = glm::all(glm::greaterThan(glm::abs(p - 0.5 * kSide), glm::dvec3(0.5 * kSide - 1)));
        return isCorner || random() % 40 == 0 ? 200.0 : 0.0;
    });
    const auto spline = [&](glm::dvec3 p) {
        double sum = 0;
        const glm::ivec3 first = glm::ivec3(glm::floor(p - 0.5)) - 1;
        for (int z = first.z; z < first.z + 4; z++)
            for (int y = first.y; y < first.y + 4; y++)
                for (int x = first.x; x < first.x + 4; x++) {
                    const glm::ivec3 at = glm::clamp(glm::ivec3(x, y, z), 0, kSide - 1);
                    sum += reference::BSpline(3, p.x - x - 0.5) * reference::BSpline(3, p.y - y - 0.5) *
                           reference::BSpline(3, p.z - z - 0.5) *
                           volume.voxels[static_cast<size_t>((at.z * kSide + at.y) * kSide + at.x)];
                }
        return sum;
    };
    const Shot shot = Shoot(volume, kExtent, {{"iso", "30"}, {"turn", "0"}, {"elevation", "0"}, {"step", "0.5"}});
    const double half = std::tan(kViewRadians / 2), reach = kSide;
    const glm::dvec3 middle(reach / 2);
    const glm::dvec3 eye = middle + glm::dvec3(0, std::sqrt(3.0) / 2 * reach / std::sin(kViewRadians / 2), 0);
    int hits = 0, others = 0;
    for (uint32_t y = 0; y < kExtent.heightTexels; y++)
        for (uint32_t x = 0; x < kExtent.widthTexels; x++) {
            const double u = (2 * (x + 0.5) / 40 - 1) * 40 / 30 * half, v = (1 - 2 * (y + 0.5) / 30) * half;
            const glm::dvec3 ray = glm::normalize(glm::dvec3(-u, -1, v));
            const glm::dvec3 a = -eye / ray, b = (reach - eye) / ray;
            const glm::dvec3 enters = glm::min(a, b), leaves = glm::max(a, b);
            const double nearest = std::max({enters.x, enters.y, enters.z});
            const double farthest = std::min({leaves.x, leaves.y, leaves.z});
            double t = nearest;
            while (t < farthest && spline(eye + t * ray) < 30)
                t += 0.5;
            const bool isHit = t < farthest;
            double lo = t - 0.5, hi = t;
            for (int i = 0; i < 40 && isHit && t > nearest; i++)
                (spline(eye + (lo + hi) / 2 * ray) < 30 ? lo : hi) = (lo + hi) / 2;
            const glm::vec4 found = shot.points[y * kExtent.widthTexels + x];
            hits += isHit;
            others += (found.w > 0) != isHit || (isHit && glm::length(glm::dvec3(found) - (eye + hi * ray)) > 0.01);
        }
    EXPECT_GT(hits, 150);
    EXPECT_LE(others, 6) << "of 1200 rays; some touch the surface within a rounding";
}

Picture Shown(const Texels& texels, Extent2D extent) {
    Picture picture{extent.widthTexels, extent.heightTexels, 3, SampleType::Float32, {}};
    for (const glm::vec4& texel : texels)
        for (int c = 0; c < 3; c++)
            picture.samples.push_back(texel[c]);
    return picture;
}

TEST(Isosurface, AQuarterOfTheStepIsTheSamePicture) {
    constexpr Extent2D kExtent{160, 120};
    // What differs are rays that touch thin crests, of which the trilinear signal is full.
    const std::tuple<const char*, const char*, const char*, double> cases[] = {
        {"head", "92", "trilinear", 0.01},
        {"head", "92", "tricubic", 0.005},
        {"marschner-lobb", "127.5", "trilinear", 0.03},
        {"marschner-lobb", "127.5", "tricubic", 0.005}};
    for (const auto& [name, iso, filter, fraction] : cases) {
        const Volume volume = SampleVolume(name);
        for (const char* shade : {"phong", "curvature"}) {
            Settings settings{{"iso", iso}, {"filter", filter}, {"shade", shade}};
            const Picture stated = Shown(Shoot(volume, kExtent, settings).picture, kExtent);
            settings.emplace_back("step", "0.125");
            const Picture quarter = Shown(Shoot(volume, kExtent, settings).picture, kExtent);
            const PictureDifference difference =
                ComparePictures(stated, quarter, {.perSample = 0.02f, .failingFraction = fraction});
            RecordProperty(fmt::format("{}_{}_{}", name, filter, shade), difference.report);
            EXPECT_TRUE(difference.isWithin) << name << " " << filter << " " << shade << ": " << difference.report;
        }
    }
}

TEST(Isosurface, VolumesThatReachTheValueAtTheirSideEndThere) {
    for (const uint32_t side : {1u, 7u}) {
        const Volume full = VolumeOf(side, glm::vec3(2), [](glm::dvec3) { return 5; });
        const Shot shot = Shoot(full, {33, 33}, {{"iso", "4.9"}, {"turn", "0"}, {"elevation", "0"}});
        const glm::vec4 point = shot.points[16 * 33 + 16];
        EXPECT_EQ(point.w, 2);
        EXPECT_NEAR(point.y, static_cast<float>(side), 1e-4);
        EXPECT_EQ(shot.points[0].w, 0);
        for (const glm::vec4 none : Shoot(full, {33, 33}, {{"iso", "5.1"}}).points)
            EXPECT_EQ(none.w, 0);
    }
}

TEST(MarschnerLobb, IsTheSignal) {
    const Volume volume = MarschnerLobb(12);
    for (int z = 0; z < 12; z++)
        for (int y = 0; y < 12; y++)
            for (int x = 0; x < 12; x++) {
                const glm::dvec3 p = (glm::dvec3(x, y, z) + 0.5) / 6.0 - 1.0;
                EXPECT_NEAR(volume.voxels[static_cast<size_t>((z * 12 + y) * 12 + x)],
                            255 * reference::MarschnerLobb(p).value, 1e-4);
            }
}

TEST(Isosurface, OffsetsInCppEqualThoseInTheShaders) {
    using March = IsosurfaceMarchConstants;
    using Shade = IsosurfaceShadeConstants;
    EXPECT_EQ(OffsetsIn(effects_shaders::Find("shaders/isosurface_march.ps.FILTER=TRICUBIC")),
              (Offsets{OFFSET(March, eyeVoxels), OFFSET(March, iso), OFFSET(March, forwardVoxels),
                       OFFSET(March, stepVoxels), OFFSET(March, rightVoxels), OFFSET(March, blocksAcross),
                       OFFSET(March, upVoxels)}));
    EXPECT_EQ(OffsetsIn(effects_shaders::Find("shaders/isosurface_shade.ps.FILTER=TRICUBIC")),
              (Offsets{OFFSET(Shade, eyeMillimetres), OFFSET(Shade, shade), OFFSET(Shade, voxelMillimetres),
                       OFFSET(Shade, radiusMillimetres), OFFSET(Shade, lightMillimetres), OFFSET(Shade, unused0),
                       OFFSET(Shade, worldX), OFFSET(Shade, unused1), OFFSET(Shade, worldY), OFFSET(Shade, unused2),
                       OFFSET(Shade, worldZ)}));
    EXPECT_EQ(OffsetsIn(effects_shaders::Find("shaders/isosurface_blocks.ps")),
              (Offsets{OFFSET(IsosurfaceBlocksConstants, blocksAcross)}));
}

}  // namespace
}  // namespace boxcar
