// The reflection on a floor, and glass, against what they must be in any scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "passes_shaders.h"
#include "test_support_shaders.h"
#include "tests/effects/effect_pictures.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtent{320, 180};

float LargestDifference(const glm::vec4& a, const glm::vec4& b) {
    const glm::vec4 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

TEST(PlanarReflection, IsTheSharpOneAtTheContact) {
    EffectPictures effect("planar-reflection", kExtent, {{"mirror", "1"}});
    const Texels glossy = effect.Picture();
    const Texels reflected = effect.Stage("reflected");
    const Texels sharp = effect.Picture({{"roughness", "0"}});
    size_t contact = 0;
    float largestElsewhere = 0;
    for (size_t i = 0; i < glossy.size(); i++) {
        const float difference = LargestDifference(glossy[i], sharp[i]);
        // A cone of 0.12 is one texel wide, as is all that is sharp, up to a height of 1 / (0.12 * focal length).
        if (reflected[i].a < 0.02f) {
            contact++;
            EXPECT_LE(difference, 1e-4f) << "texel " << i % 320 << ", " << i / 320;
        }
        largestElsewhere = std::max(largestElsewhere, difference);
    }
    EXPECT_GT(contact, 20u);
    EXPECT_GT(largestElsewhere, 0.1f) << "nothing was blurred";
}

// A mirror shows the mirrored scene texel for texel. (Where objects stand before the floor it shows them.)
TEST(PlanarReflection, OfAMirrorIsTheMirroredScene) {
    EffectPictures effect("planar-reflection", kExtent, {{"mirror", "1"}, {"roughness", "0"}});
    const Texels picture = effect.Picture(), reflected = effect.Stage("reflected");
    size_t onObjects = 0, same = 0;
    for (size_t i = 0; i < picture.size(); i++) {
        if (reflected[i].a > 2) continue;  // sky
        onObjects++;
        same += LargestDifference(picture[i], reflected[i]) < 4e-5f;
    }
    EXPECT_GT(onObjects, 1000u);
    EXPECT_GT(same, onObjects / 2);
}

TEST(PlanarReflection, WidthGrowsWithTheDistanceAndIsTheConeSeenFromTheEye) {
    Texels rays;
    for (int i = 0; i < 200; i++)
        rays.emplace_back(0.02f * static_cast<float>(i * i), 5.0f, 60.0f, 0.0f);
    const Image image = Upload({200, 1}, rays);
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/footprint_cone.ps")});
    const Texels widths =
        RunOnDevice({200, 1}, rays, [&](CommandList& commands, const Image& source) -> const Image& {
            static const Image result(TestDevice(), {{200, 1}, Format::RGBA32F, "widths"});
            commands.Draw(
                {.name = "widths", .pipeline = pipeline, .reads = {{"rays", &source}}, .writes = {&result}});
            return result;
        });
    for (size_t i = 0; i < widths.size(); i++) {
        // A screen d away with 60 texels to a unit at distance 1: the ray spreads to its length times the cone there.
        const double length = rays[i].x;
        EXPECT_NEAR(widths[i].x, std::max(1.0, 60 * length / (length + 5)), 1e-4);
        if (i > 0) {
            EXPECT_GE(widths[i].x, widths[i - 1].x);
        }
    }
    EXPECT_EQ(widths[0].x, 1);
}

// Mean absolute difference of neighbours along x, over the picture.
double Roughness(const Texels& picture) {
    double sum = 0;
    for (uint32_t y = 0; y < kExtent.heightTexels; y++)
        for (uint32_t x = 1; x < kExtent.widthTexels; x++) {
            const size_t i = size_t{y} * kExtent.widthTexels + x;
            sum += LargestDifference(picture[i], picture[i - 1]);
        }
    return sum / static_cast<double>(kExtent.Texels());
}

TEST(Translucency, MoreEtchingShowsLessOfWhatIsBehind) {
    EffectPictures effect("translucency", kExtent, {{"bending", "0"}});
    double before = Roughness(effect.Picture({{"etching", "0"}}));
    for (const char* etching : {"0.05", "0.15", "0.5"}) {
        const double now = Roughness(effect.Picture({{"etching", etching}}));
        EXPECT_LT(now, before) << etching;
        before = now;
    }
}

// The nearest object is a sphere of radius 0.32 at (0.5, 0.32, 1.1), seen from (0, 1.25, 4.4) towards (0, 0.62, 0) at
// 0.62 radians. Where a ray leaves it, in double.
TEST(Translucency, BlursByTheThicknessOfTheGlass) {
    EffectPictures effect("translucency", kExtent, {{"bending", "0"}});
    const Texels clear = effect.Picture({{"etching", "0"}}), etched = effect.Picture({{"etching", "0.4"}});
    const Texels farSide = effect.Stage("far-side");
    const glm::dvec3 eye(0, 1.25, 4.4), centre(0.5, 0.32, 1.1);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(0, 0.62, 0) - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0))),
                     up = glm::cross(right, forward);
    double thin = 0, thick = 0;
    int thins = 0, thicks = 0;
    for (uint32_t y = 0; y < kExtent.heightTexels; y++)
        for (uint32_t x = 0; x < kExtent.widthTexels; x++) {
            const double half = std::tan(0.31), px = (2 * x + 1.0) / 320 - 1, py = 1 - (2 * y + 1.0) / 180;
            const glm::dvec3 ray = glm::normalize(forward + half * (px * 320 / 180 * right + py * up));
            const double along = glm::dot(centre - eye, ray);
            const double chord = 0.32 * 0.32 - (glm::dot(centre - eye, centre - eye) - along * along);
            if (chord <= 0.001) continue;
            const size_t i = size_t{y} * kExtent.widthTexels + x;
            EXPECT_NEAR(farSide[i].x, along + std::sqrt(chord), 0.01) << x << ", " << y;
            const float change = LargestDifference(clear[i], etched[i]);
            if (2 * std::sqrt(chord) < 0.2) {
                thin += change;
                thins++;
            } else if (2 * std::sqrt(chord) > 0.5) {
                thick += change;
                thicks++;
            }
        }
    EXPECT_GT(thins, 50);
    EXPECT_GT(thicks, 500);
    EXPECT_GT(thick / thicks, 2 * thin / thins);
}

TEST(ParaboloidDirect, SubdivisionCuresTheStraightLines) {
    double before = 0;
    for (const char* subdivisions : {"0", "1", "2", "3", "4"}) {
        EffectPictures effect("paraboloid-direct", {64, 32}, {{"subdivisions", subdivisions}, {"face", "128"}});
        effect.Picture();
        const Texels direct = effect.Stage("front-direct"), viaCube = effect.Stage("front-cube");
        double wrong = 0, all = 0;
        for (int y = 0; y < 128; y++)
            for (int x = 0; x < 128; x++) {
                if (std::hypot(x - 63.5, y - 63.5) > 63) continue;
                all++;
                wrong += LargestDifference(direct[y * 128 + x], viaCube[y * 128 + x]) > 0.1f;
            }
        if (before > 0) {
            EXPECT_LT(wrong / all, before) << subdivisions;
        }
        before = wrong / all;
        RecordProperty("wrong_at_" + std::string(subdivisions), std::to_string(before));
    }
    // What is left are the edges of the checks, which the cube map resolves by other texels.
    EXPECT_LT(before, 0.1);
}

}  // namespace
}  // namespace boxcar
