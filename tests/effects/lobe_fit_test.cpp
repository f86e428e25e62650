// Stacks of boxes: their errors against sums over a grid, and those that the shaders use.
#include "samples/effects/lobe_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "passes_shaders.h"
#include "test_support_shaders.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

// The distance of lobe and stack over the lobe's norm, by adding up a grid over the disc.
double GridError(const Lobe& lobe, const BoxStackFit& fit, double reach) {
    constexpr int kCells = 1000;
    const double step = 2 * reach / kCells;
    double light = 0, squared = 0, difference = 0;
    const auto forEach = [&](auto add) {
        for (int y = 0; y < kCells; y++)
            for (int x = 0; x < kCells; x++) {
                const double px = (x + 0.5) * step - reach, py = (y + 0.5) * step - reach;
                const double rho = std::hypot(px, py);
                add(rho <= 1 ? lobe(rho) : 0.0, std::max(std::abs(px), std::abs(py)));
            }
    };
    forEach([&](double g, double) { light += g * step * step; });
    forEach([&](double g, double chebyshev) {
        double stack = 0;
        for (size_t i = 0; i < fit.weights.size(); i++)
            if (chebyshev < fit.halfWidths[i]) stack += fit.weights[i] / (4 * fit.halfWidths[i] * fit.halfWidths[i]);
        squared += g * g / (light * light);
        difference += (g / light - stack) * (g / light - stack);
    });
    return std::sqrt(difference / squared);
}

TEST(LobeFit, NarrowPhongLobesReachTheErrorsOfAGaussian) {
    constexpr double kErrors[] = {52.9, 33.3, 25.9, 22.1, 20.0, 18.6};
    for (int boxes = 1; boxes <= 6; boxes++) {
        const BoxStackFit fit = FitBoxStack(PhongLobe(2000), boxes);
        EXPECT_NEAR(100 * fit.relativeError, kErrors[boxes - 1], 0.5) << boxes;
        double sum = 0;
        for (const double weight : fit.weights)
            sum += weight;
        EXPECT_NEAR(sum, 1, 1e-9);
    }
}

TEST(LobeFit, TheErrorIsThatOfAGrid) {
    for (const int boxes : {1, 3, 5}) {
        const BoxStackFit phong = FitBoxStack(PhongLobe(40), boxes);
        EXPECT_NEAR(phong.relativeError, GridError(PhongLobe(40), phong, 1), 0.01) << boxes;
        const BoxStackFit ggx = FitBoxStack(GgxLobe(0.2), boxes);
        EXPECT_NEAR(ggx.relativeError, GridError(GgxLobe(0.2), ggx, 1), 0.01) << boxes;
    }
}

TEST(LobeFit, NoStackNearbyIsBetter) {
    const BoxStackFit best = FitBoxStack(GgxLobe(0.1), 3);
    for (size_t i = 0; i < 3; i++)
        for (const double factor : {0.97, 1.03}) {
            BoxStackFit other = best;
            other.halfWidths[i] *= factor;
            EXPECT_GE(GridError(GgxLobe(0.1), other, 1), GridError(GgxLobe(0.1), best, 1) - 1e-3);
        }
}

// hlsl/boxcar/box_stack.hlsli, in sigma = 0.5 / sqrt(n).
TEST(LobeFit, TheShadersStacksAreTheBestOnes) {
    const double sigma = 0.5 / std::sqrt(20000.0);
    const Pipeline pipeline(
        TestDevice(), {passes_shaders::Find("shaders/quad.vs"), test_support_shaders::Find("shaders/box_stack.ps")});
    const Image table(TestDevice(), {{6, 6}, Format::RGBA32F, "stacks"});
    CommandList commands(TestDevice());
    commands.Draw({.name = "stacks", .pipeline = pipeline, .writes = {&table}});
    commands.SubmitAndWait();
    const Texels stacks = Download(table);
    for (size_t boxes = 1; boxes <= 6; boxes++) {
        const BoxStackFit fit = FitBoxStack(PhongLobe(20000), static_cast<int>(boxes));
        for (size_t i = 0; i < boxes; i++) {
            const glm::vec4& shown = stacks[(boxes - 1) * 6 + i];
            EXPECT_NEAR(fit.halfWidths[i] / sigma, shown.x, 0.002) << boxes << ", " << i;
            EXPECT_NEAR(fit.weights[i], shown.y, 0.001) << boxes << ", " << i;
        }
    }
}

TEST(LobeFit, RefusesDarkness) {
    EXPECT_ERROR(FitBoxStack([](double) { return 0.0; }, 2), "a lobe of no light, or of no end of it");
}

}  // namespace
}  // namespace boxcar
