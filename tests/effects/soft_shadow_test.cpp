// Moments from a table against their definition in double; and the shadows that the effect draws with them. Alpha of
// its picture is the share of the lamp that a pixel sees.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "effects_shaders.h"
#include "hlsl/constants/effect_constants.h"
#include "passes_shaders.h"
#include "runtime/passes/summed_area_table.h"
#include "samples/scenes/environment.h"
#include "test_support_shaders.h"
#include "tests/effects/effect_pictures.h"
#include "tests/hlsl/test_constants.h"
#include "tests/support/offsets.h"

namespace boxcar {
namespace {

struct Moments {
    double mean = 0, variance = 0;
};

// Weighted by how much of each texel lies in the box; depth as whole codes of 16 bits.
Moments MomentsOf(const Texels& depth, Extent2D extent, const glm::vec4& box) {
    const auto covered = [](double texel, double lo, double hi) {
        return std::max(0.0, std::min(hi, texel + 1) - std::max(lo, texel));
    };
    const auto sum = [&](auto value) {
        double total = 0;
        for (uint32_t y = 0; y < extent.heightTexels; y++)
            for (uint32_t x = 0; x < extent.widthTexels; x++)
                total += covered(x, box.x, box.z) * covered(y, box.y, box.w) *
                         value(std::floor(65535.0 * depth[y * extent.widthTexels + x].x + 0.5));
        return total;
    };
    const double area = sum([](double) { return 1.0; });
    const double mean = sum([](double code) { return code; }) / area;
    return {mean, sum([&](double code) { return (code - mean) * (code - mean); }) / area};
}

// What the device makes of them: (mean, variance, share that can be `value` or more).
Texels DeviceMoments(const Texels& depth, Extent2D extent, const Texels& boxes, float value) {
    const Image depthImage = Upload(extent, depth), low(TestDevice(), {extent, Format::RGBA32UI, "low"}),
                high(TestDevice(), {extent, Format::RGBA32UI, "high"});
    const Extent2D boxesExtent{static_cast<uint32_t>(boxes.size()), 1};
    const Image boxImage = Upload(boxesExtent, boxes), result(TestDevice(), {boxesExtent, Format::RGBA32F, "result"});
    const Pipeline encode(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                         effects_shaders::Find("shaders/shadow_moments.ps"),
                                         {Format::RGBA32UI, Format::RGBA32UI}});
    const Pipeline read(TestDevice(), {.vertex = passes_shaders::Find("shaders/quad.vs"),
                                       .pixel = test_support_shaders::Find("shaders/sat_moments.ps")});
    SummedAreaTable table(TestDevice(), {.extent = extent, .precision = SATPrecision::U64});
    CommandList commands(TestDevice());
    commands.Draw({.name = "encode", .pipeline = encode, .reads = {{"depth", &depthImage}}, .writes = {&low, &high}});
    const TexelWords sums = table.Record(commands, {low, high});
    const SampleConstants constants{{extent.widthTexels, extent.heightTexels}, {value, 0}, {}};
    commands.Draw({.name = "read",
                   .pipeline = read,
                   .reads = {{"table", sums.low}, {"tableHigh", sums.high}, {"boxes", &boxImage}},
                   .writes = {&result},
                   .constants = ConstantBytes(constants)});
    commands.SubmitAndWait();
    return Download(result);
}

Texels RandomBoxes(Extent2D extent, size_t count) {
    std::mt19937 random(71);
    std::uniform_real_distribution<float> unit(0, 1);
    Texels boxes;
    const auto width = static_cast<float>(extent.widthTexels), height = static_cast<float>(extent.heightTexels);
    while (boxes.size() < count) {
        const bool isSmall = boxes.size() % 2 == 0;
        const glm::vec2 lo(unit(random) * (width - 1), unit(random) * (height - 1));
        const glm::vec2 size =
            isSmall ? glm::vec2(1 + 5 * unit(random)) : glm::vec2(unit(random) * width, unit(random) * height) + 1.0f;
        boxes.emplace_back(lo, glm::min(lo + size, glm::vec2(width, height)));
    }
    return boxes;
}

// Depths: of all magnitudes; within a few codes of each other, far from 0, where sums of squares in float32 have no
// digit left; all the same; a slope; and the depth map of the effect.
TEST(SATMoments, AreThoseOfTheDefinitionOverAnyBox) {
    EffectPictures scene("soft-shadow", {8, 8}, {{"map", "96"}});
    scene.Picture({});

    const Extent2D extent{96, 96};
    std::map<std::string, Texels> depths;
    depths["effect"] = scene.Stage("depth");
    depths["noise"] = RandomValues(extent, 72);
    for (const glm::vec4 noise : depths["noise"]) {
        depths["close"].emplace_back((60000 + std::floor(4 * noise.x)) / 65535);
        depths["equal"].emplace_back(0.987f);
    }
    for (uint32_t i = 0; i < extent.Texels(); i++)
        depths["slope"].emplace_back(0.2f + 0.004f * static_cast<float>(i % 96) +
                                     0.002f * static_cast<float>(i / 96));
    // Next to whole codes, so that both sides round to the same ones.
    for (auto& [name, depth] : depths)
        for (glm::vec4& texel : depth)
            texel.x = std::round(texel.x * 65535) / 65535;
    const Texels boxes = RandomBoxes(extent, 400);
    for (const auto& [name, depth] : depths) {
        const Texels actual = DeviceMoments(depth, extent, boxes, 0);
        double worstMean = 0, worstVariance = 0;
        for (size_t i = 0; i < boxes.size(); i++) {
            const Moments expected = MomentsOf(depth, extent, boxes[i]);
            worstMean = std::max(worstMean, std::abs(actual[i].x - expected.mean));
            worstVariance =
                std::max(worstVariance, std::abs(actual[i].y - expected.variance) / (expected.variance + 1));
            EXPECT_GE(actual[i].y, 0);
        }
        std::printf("%s: mean off by %.2g codes, variance by %.2g of it\n", name.c_str(), worstMean, worstVariance);
        EXPECT_LT(worstMean, 0.005) << name;
        EXPECT_LT(worstVariance, 2e-6) << name;
    }
}

// Two depths, the larger one on a share p of a box: variance p (1 - p) d^2, and the mean (1 - p) d below the larger.
TEST(SATMoments, UpperShareIsThatOfTheLargerOfTwoDepths) {
    const Extent2D extent{40, 30};
    Texels depth;
    for (const glm::vec4 noise : RandomValues(extent, 73))
        depth.emplace_back(noise.x < 0.4f ? 20000 / 65535.0f : 50000 / 65535.0f);
    const Texels boxes = RandomBoxes(extent, 200);
    const Texels actual = DeviceMoments(depth, extent, boxes, 50000);
    for (size_t i = 0; i < boxes.size(); i++)
        EXPECT_NEAR(actual[i].z, (MomentsOf(depth, extent, boxes[i]).mean - 20000) / 30000, 1e-4);
}

struct Shadows {
    Texels picture, positions;
};

EffectPictures Scene(Extent2D extent, const Settings& fixed = {}) {
    return {"soft-shadow", extent, fixed};
}

Shadows Draw(EffectPictures& scene, const Settings& settings) {
    Texels picture = scene.Picture(settings);
    return {std::move(picture), scene.Stage("positions")};
}

// The effect's lamp at time 0, and its three spheres of radius 0.25.
const double kElevation = glm::radians(50.0), kAzimuth = 0.75;
const glm::dvec3 kLamp = 7.0 * glm::dvec3(std::cos(kElevation) * std::sin(kAzimuth), std::sin(kElevation),
                                          std::cos(kElevation) * std::cos(kAzimuth));
const glm::dvec3 kAcross(std::cos(kAzimuth), 0, -std::sin(kAzimuth));
constexpr glm::dvec3 kSpheres[] = {{1.3, 0.25, 0.9}, {1.9, 0.85, 0}, {1.0, 1.6, -1.2}};

glm::dvec3 ShadowOf(const glm::dvec3& centre) {
    return kLamp + (centre - kLamp) * kLamp.y / (kLamp.y - centre.y);
}

// The pixels of the ground: where, and the share of the lamp.
struct GroundPixel {
    glm::dvec3 world;
    double share;
};

std::vector<GroundPixel> GroundOf(const Shadows& shadows) {
    std::vector<GroundPixel> ground;
    for (size_t i = 0; i < shadows.positions.size(); i++)
        if (shadows.positions[i].w > 0 && std::abs(shadows.positions[i].y) < 1e-4)
            ground.push_back({glm::vec3(shadows.positions[i]), shadows.picture[i].w});
    return ground;
}

// How far it is from a share of 0.15 to one of 0.85, on the way from the middle of a sphere's shadow sideways.
double PenumbraWorld(const std::vector<GroundPixel>& ground, const glm::dvec3& shadow) {
    const glm::dvec3 along(std::sin(kAzimuth), 0, std::cos(kAzimuth));
    std::vector<std::pair<double, double>> profile;  // distance, share
    for (const GroundPixel& pixel : ground) {
        const glm::dvec3 offset = pixel.world - shadow;
        const double sideways = glm::dot(offset, kAcross);
        if (std::abs(glm::dot(offset, along)) < 0.04 && sideways < 0 && sideways > -1)
            profile.emplace_back(-sideways, pixel.share);
    }
    std::sort(profile.begin(), profile.end());
    const auto first = [&](double share) {
        for (const auto& [distance, value] : profile)
            if (value > share) return distance;
        ADD_FAILURE() << "no share over " << share;
        return 0.0;
    };
    return first(0.85) - first(0.15);
}

// The rim of a lamp of width L is L (r - b) / b wide, for a receiver r and a blocker b away. A cut of 0.2 leaves four
// fifths of its ramp, and what is measured is 0.7 of that.
TEST(SoftShadow, PenumbrasGrowWithTheLampAndWithTheDistanceFromWhatCastsThem) {
    EffectPictures scene = Scene({480, 300});
    for (const double lamp : {0.4, 0.8}) {
        const auto ground = GroundOf(Draw(scene, {{"light-size", fmt::format("{}", lamp)}}));
        double before = 0;
        for (const glm::dvec3& sphere : kSpheres) {
            const double toSphere = glm::length(sphere - kLamp), toGround = glm::length(ShadowOf(sphere) - kLamp);
            const double expected = 0.7 * 0.8 * lamp * (toGround - toSphere) / toSphere;
            const double width = PenumbraWorld(ground, ShadowOf(sphere));
            std::printf("lamp %.1f, sphere %.2f over the ground: %.3f, expected %.3f\n", lamp, sphere.y, width,
                        expected);
            EXPECT_GT(width, 1.4 * before);
            EXPECT_NEAR(width, expected, 0.2 * expected + 0.015);  // a pixel is 0.01 wide, a texel of the map 0.013
            before = width;
        }
    }
}

TEST(SoftShadow, WhatSeesTheLampIsLitAndTheMiddleOfAShadowIsDark) {
    EffectPictures scene = Scene({320, 200});
    for (const char* cut : {"0", "0.2"}) {
        const Shadows shadows = Draw(scene, {{"light-size", "0.4"}, {"bleed-cut", cut}});
        size_t lit = 0, dark = 0;
        double least = 1, most = 0;
        for (const GroundPixel& pixel : GroundOf(shadows)) {
            if (pixel.world.z > 1.6) {  // the lamp's side: no shadow falls there
                least = std::min(least, pixel.share);
                lit++;
            }
            for (const glm::dvec3& sphere : kSpheres)
                if (glm::length(pixel.world - ShadowOf(sphere)) < 0.08) {
                    most = std::max(most, pixel.share);
                    dark++;
                }
        }
        std::printf("cut %s: lit %.4f and more, dark %.4f and less\n", cut, least, most);
        EXPECT_EQ(least, 1);
        EXPECT_LE(most, std::string(cut) == "0" ? 0.2 : 0);
        EXPECT_GT(lit, 5000u);
        EXPECT_GT(dark, 20u);
    }
}

// A lamp without size casts the shadows of single texels, but for a texel at their rims.
TEST(SoftShadow, OfALampWithoutSizeIsHard) {
    EffectPictures scene = Scene({320, 200});
    const Shadows soft = Draw(scene, {{"light-size", "0"}}), hard = Draw(scene, {{"method", "hard"}});
    size_t dark = 0, other = 0;
    for (size_t i = 0; i < soft.picture.size(); i++)
        if (soft.positions[i].w > 0 && std::abs(soft.positions[i].y) < 1e-4) {
            dark += hard.picture[i].w == 0;
            other += std::abs(soft.picture[i].w - hard.picture[i].w) > 0.6f;
        }
    EXPECT_GT(dark, 500u);
    EXPECT_LT(other, dark / 10);
}

TEST(SoftShadow, OffsetsInCppEqualThoseInTheShaders) {
    const Offsets all = {OFFSET(SoftShadowConstants, clipFromWorld), OFFSET(SoftShadowConstants, lampWorld),
                         OFFSET(SoftShadowConstants, nearWorld),     OFFSET(SoftShadowConstants, reachWorld),
                         OFFSET(SoftShadowConstants, lampSizeWorld), OFFSET(SoftShadowConstants, texelsAtOne),
                         OFFSET(SoftShadowConstants, bleedCut),      OFFSET(SoftShadowConstants, skyLight),
                         OFFSET(SoftShadowConstants, unused)};
    EXPECT_EQ(OffsetsIn(effects_shaders::Find("shaders/soft_shadow.ps.HARD=0")), all);
}

}  // namespace
}  // namespace boxcar
