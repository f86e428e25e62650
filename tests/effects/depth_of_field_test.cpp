// The ways to depth of field, measured by 256 views from all over the lens.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "runtime/passes/layered_depth_of_field.h"
#include "samples/effects/effects.h"
#include "tests/reference/similarity.h"
#include "tests/support/device_image.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtent{240, 150};
constexpr double kUnitTexels = 150 / (2 * 0.32049);  // across a unit at depth 1: the view is 2 tan(0.31) high

struct Shot {
    Texels picture;
    Texels nearest;  // disparity in alpha; not for `accumulation`
    size_t passes;
};

Shot Render(const std::string& method, const std::vector<std::pair<std::string, std::string>>& settings,
            Extent2D extent = kExtent) {
    const EffectInfo& info = FindEffect("depth-of-field");
    ParameterValues values(info.parameters);
    values.Set("method", method);
    for (const auto& [name, value] : settings)
        values.Set(name, value);
    const auto effect = info.make(TestDevice(), {.extent = extent, .mesh = SampleMesh("bunny")}, values);
    CommandList commands(TestDevice(), CommandList::Timing::On);
    const Image& picture = effect->Record(commands, {0, values});
    commands.SubmitAndWait();
    Shot shot{Download(picture), {}, commands.PassTimes().size()};
    for (const EffectStage& stage : effect->Stages())
        if (stage.name == "nearest") shot.nearest = Download(*stage.image);
    return shot;
}

double Similarity(const Shot& a, const Shot& b) {
    return reference::StructuralSimilarity(kExtent.widthTexels, kExtent.heightTexels, a.picture, b.picture);
}

// Focus on the bunny, and behind it; the sky's circles are 23 and 10 texels wide, the nearest ball's 38 and 52.
TEST(DepthOfField, LayersLookLikeTheMeanOf256Views) {
    for (const char* focus : {"5", "12"}) {
        const Shot views = Render("accumulation", {{"focus", focus}, {"lens", "0.5"}});
        const double layered = Similarity(Render("layered", {{"focus", focus}, {"lens", "0.5"}}), views);
        EXPECT_GE(layered, 0.95) << "focus " << focus;
        std::string line = fmt::format("focus {}: layered {:.4f}", focus, layered);
        for (const char* method : {"single", "mips", "noise", "sharp"})
            line += fmt::format(", {} {:.4f}", method,
                                Similarity(Render(method, {{"focus", focus}, {"lens", "0.5"}}), views));
        fmt::print("{}\n", line);
    }
}

// All methods are linear in the light of the bunny, so the difference that its light makes is what comes from it.
Texels LightOfTheBunny(const std::string& method) {
    const Texels bright = Render(method, {{"lens", "0.5"}, {"object", "1"}}).picture;
    Texels light = Render(method, {{"lens", "0.5"}, {"object", "0"}}).picture;
    for (size_t i = 0; i < light.size(); i++)
        light[i] = bright[i] - light[i];
    return light;
}

// Light that 256 views do not show where the bunny is not.
double Bleeding(const Texels& light, const Texels& views, const Texels& sharp) {
    double sum = 0;
    for (size_t i = 0; i < light.size(); i++)
        if (sharp[i].r == 0) sum += std::max(0.0f, light[i].r - views[i].r);
    return sum;
}

TEST(DepthOfField, WhatIsSharpBleedsFromATableOfThePictureAndNotFromLayers) {
    const Texels sharp = LightOfTheBunny("sharp"), views = LightOfTheBunny("accumulation");
    double all = 0;
    for (const glm::vec4& texel : sharp)
        all += texel.r;
    const double single = Bleeding(LightOfTheBunny("single"), views, sharp),
                 layered = Bleeding(LightOfTheBunny("layered"), views, sharp);
    fmt::print("bleeding, per cent of the bunny's red light: single {:.3f}, layered {:.4f}\n", 100 * single / all,
               100 * layered / all);
    EXPECT_GT(single, 0.01 * all);
    EXPECT_LT(layered, 0.1 * single);
}

// A red leaf over the left half, its circles 21 texels wide, before a wall in focus with stripes of green and blue,
// all of which is known. At a distance x from its edge, the leaf covers the segment of a disc; through the rest the
// wall is seen as sharp as it is.
TEST(DepthOfField, WhatANearThingHidesIsSeenThroughItsRim) {
    constexpr Extent2D extent{80, 40};
    Texels nearest, hidden;
    for (int i = 0; i < 80 * 40; i++) {
        hidden.push_back(i % 2 ? glm::vec4(0, 0, 1, 0.2f) : glm::vec4(0, 1, 0, 0.2f));
        nearest.push_back(i % 80 < 40 ? glm::vec4(1, 0, 0, 0.8f) : hidden.back());
    }
    const Image nearestImage = Upload(extent, nearest), hiddenImage = Upload(extent, hidden);
    LayeredDepthOfField effect(TestDevice(), {.extent = extent});
    CommandList commands(TestDevice());
    const Image& result = effect.Record(commands, nearestImage, &hiddenImage, {0.2f, 35}, 0.8f, 4);
    commands.SubmitAndWait();
    const Texels picture = Download(result);
    for (int x = 0; x < 80; x++) {
        const double side = std::clamp((40 - x - 0.5) / 10.5, -1.0, 1.0);
        const double covered = 0.5 + (std::asin(side) + side * std::sqrt(1 - side * side)) / std::numbers::pi;
        const glm::vec4 texel = picture[static_cast<size_t>(20 * 80 + x)];
        EXPECT_NEAR(texel.r, covered, 0.055) << "column " << x;  // 0.05 of it closes gaps between layers
        EXPECT_NEAR(texel.r + (x % 2 ? texel.b : texel.g), 1, 1e-4) << "column " << x;
    }
}

// Those whose circle is one texel. Layers may put something nearer over them, and its circle may be taken for the
// next layer's, not twice as wide.
TEST(DepthOfField, WhatIsInFocusIsThePinholesPictureTo1Over255) {
    const double aperture = 0.3 * kUnitTexels;
    const Shot sharp = Render("sharp", {{"lens", "0.3"}}), layered = Render("layered", {{"lens", "0.3"}}),
               single = Render("single", {{"lens", "0.3"}});
    const auto w = static_cast<int>(kExtent.widthTexels), h = static_cast<int>(kExtent.heightTexels);
    const auto at = [&](int x, int y) { return static_cast<size_t>(y * w + x); };
    const auto circle = [&](size_t i) {
        return aperture * (sharp.nearest[i].a - 0.2);
    };  // more than 0: before the focus
    std::vector<bool> isCovered(sharp.picture.size());
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            const double c = circle(at(x, y));
            if (c <= 1) continue;
            const int reach = static_cast<int>(c) + 1;
            for (int j = std::max(y - reach, 0); j <= std::min(y + reach, h - 1); j++)
                for (int i = std::max(x - reach, 0); i <= std::min(x + reach, w - 1); i++)
                    isCovered[at(i, j)] = true;
        }
    const auto expectSharp = [&](const Shot& shot, size_t i, const char* name) {
        for (int c = 0; c < 3; c++)
            ASSERT_NEAR(reference::EncodedSrgb(shot.picture[i][c]), reference::EncodedSrgb(sharp.picture[i][c]),
                        1 / 255.0)
                << name << ", texel " << i;
    };
    int inFocus = 0, uncovered = 0;
    for (size_t i = 0; i < sharp.picture.size(); i++) {
        if (std::abs(circle(i)) > 0.999) continue;
        inFocus++;
        expectSharp(single, i, "single");
        if (isCovered[i]) continue;
        uncovered++;
        expectSharp(layered, i, "layered");
    }
    EXPECT_GT(inFocus, 2500);
    EXPECT_GT(uncovered, 1600);
}

// Focused far away, the bunny's picture grows by the circle of its rim, A |1 / z - 1 / focus|; z is 4.3 to 5.3 there.
TEST(DepthOfField, ViewsSpreadAPointOverItsCircleOfConfusion) {
    const auto columns = [](const std::string& method) {
        const auto settings = [](const char* object) {
            return std::vector<std::pair<std::string, std::string>>{
                {"lens", "0.5"}, {"focus", "40"}, {"object", object}};
        };
        const Texels bright = Render(method, settings("1")).picture, dark = Render(method, settings("0")).picture;
        int first = 1000, last = -1;
        for (size_t i = 0; i < bright.size(); i++)
            if (bright[i].r - dark[i].r > 1e-5) {
                first = std::min(first, static_cast<int>(i % kExtent.widthTexels));
                last = std::max(last, static_cast<int>(i % kExtent.widthTexels));
            }
        return last - first + 1;
    };
    const int grown = columns("accumulation") - columns("sharp");
    EXPECT_GE(grown, 0.5 * kUnitTexels * (1 / 5.3 - 1 / 40.0) - 1.5);
    EXPECT_LE(grown, 0.5 * kUnitTexels * (1 / 4.3 - 1 / 40.0) + 1);
}

// Circles of a radius of 4 texels and of 64 take the same draws, and a texel reads the same tables.
TEST(DepthOfField, LayersTakeTheSamePassesForAnyLens) {
    EXPECT_EQ(Render("layered", {{"lens", "0.17"}}).passes, Render("layered", {{"lens", "2"}}).passes);
}

TEST(DepthOfField, EveryMethodDrawsEverySize) {
    for (const char* method : {"layered", "single", "mips", "noise", "accumulation", "sharp"})
        for (const auto& [extent, lens] : {std::pair(Extent2D{1, 1}, "2"), std::pair(Extent2D{63, 37}, "0.4")})
            for (const glm::vec4& texel : Render(method, {{"lens", lens}}, extent).picture)
                for (int c = 0; c < 3; c++)
                    ASSERT_TRUE(std::isfinite(texel[c]) && texel[c] >= 0) << method;
}

}  // namespace
}  // namespace boxcar
