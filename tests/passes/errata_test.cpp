// The papers' errata on building and box lookup that no other test pins: what is printed, and what is right.
#include <gtest/gtest.h>

#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "runtime/passes/sat_verbatim_blur.h"
#include "runtime/passes/summed_area_table.h"
#include "runtime/ping_pong.h"
#include "test_support_shaders.h"
#include "tests/support/device_image.h"

namespace boxcar {
namespace {

// tex2D_SAT_blur of a 16 x 16 picture, all 0 but `value` at (8, 8); its row 8.
std::vector<float> VerbatimBlurOfAnImpulse(float sizeTexels, float value = 1) {
    const Extent2D extent{16, 16};
    Texels source(256, glm::vec4(0));
    source[16 * 8 + 8] = glm::vec4(value);
    SummedAreaTable table(TestDevice(), {.extent = extent});
    SatVerbatimBlur verbatim(TestDevice(), extent);
    const Texels result = RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
        return verbatim.Record(commands, *table.Record(commands, image).low, glm::vec2(sizeTexels));
    });
    std::vector<float> row;
    for (int x = 0; x < 16; x++)
        row.push_back(result[16 * 8 + x].x);
    return row;
}

// The first and the last texel whose box holds the impulse. (Texels whose box sticks out at the right are negative.)
std::pair<int, int> Reach(const std::vector<float>& row) {
    int first = -1, last = -1;
    for (int x = 0; x < 16; x++) {
        if (row[x] <= 0) continue;
        if (first < 0) first = x;
        last = x;
    }
    return {first, last};
}

// A box of 4 round texel i is [i - 1.5, i + 2.5): the impulse at 8 is right when it reaches 6 .. 10, half at the
// ends. As printed texel i takes i - 1 .. i + 2 whole.
TEST(SATVerbatimBlur, EvenSizesLieHalfATexelTooFarRight) {
    EXPECT_EQ(Reach(VerbatimBlurOfAnImpulse(4)), std::pair(6, 9));
}

// A box of 3 round texel i is i - 1 .. i + 1: the impulse is right when it reaches 7 .. 9. As printed: i .. i + 2.
TEST(SATVerbatimBlur, OddSizesLieAWholeTexelTooFarRight) {
    EXPECT_EQ(Reach(VerbatimBlurOfAnImpulse(3)), std::pair(6, 8));
}

// The mean over 16 texels of one that is 16 is 1. As printed it is divided by an area in uv, (4 / 16)^2.
TEST(SATVerbatimBlur, IsTooBrightByTheNumberOfTexels) {
    EXPECT_EQ(VerbatimBlurOfAnImpulse(4, 16)[8], 16.0f * 16.0f);
}

// A constant picture darkens where the printed lookup leaves the table, and reads 0.
TEST(SATVerbatimBlur, DoesNotClipAtTheRightRim) {
    const Extent2D extent{16, 16};
    SummedAreaTable table(TestDevice(), {.extent = extent});
    SatVerbatimBlur verbatim(TestDevice(), extent);
    const Texels result = RunOnDevice(
        extent, Texels(256, glm::vec4(1)), [&](CommandList& commands, const Image& image) -> const Image& {
            return verbatim.Record(commands, *table.Record(commands, image).low, glm::vec2(4));
        });
    EXPECT_EQ(result[16 * 8 + 8].x, 256.0f);
    EXPECT_LT(result[16 * 8 + 15].x, 0.0f);
}

// The right corners, from the table on the device: T(x + a) - T(x) covers x + 1 .. x + a (Green's slide, whose minus
// signs are lost, reads there).
TEST(BoxLookup, DifferencesOfEntriesLeaveOutTheirFirstTexel) {
    const Extent2D extent{8, 8};
    const Texels source = RandomCodes(extent, 21);
    SummedAreaTable sums(TestDevice(), {.extent = extent});
    const Texels table = RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
        return *sums.Record(commands, image).low;
    });
    const int x = 1, y = 2, a = 3, b = 4;
    float covered = 0;
    for (int j = y + 1; j <= y + b; j++)
        for (int i = x + 1; i <= x + a; i++)
            covered += source[8 * j + i].x;
    const auto at = [&](int i, int j) { return table[8 * j + i].x; };
    EXPECT_EQ(at(x + a, y + b) - at(x + a, y) - at(x, y + b) + at(x, y), covered);
}

// Builds with two taps and a sampler that clamps to the edge.
Texels BuildWithClampToEdge(Extent2D extent, const Texels& source) {
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/sat_pass_clamp.ps")});
    PingPong targets(TestDevice(), {extent, Format::RGBA32F, "clamped table"});
    return RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
        const Image* from = &image;
        for (const glm::vec2 axis : {glm::vec2(1, 0), glm::vec2(0, 1)}) {
            const uint32_t side = axis.x > 0 ? extent.widthTexels : extent.heightTexels;
            for (uint32_t stride = 1; stride < side; stride *= 2) {
                const SATPassConstants constants{
                    axis * static_cast<float>(stride) / glm::vec2(extent.widthTexels, extent.heightTexels), {}, {}};
                commands.Draw({.name = "clamped pass",
                               .pipeline = pipeline,
                               .reads = {{"source", from}},
                               .writes = {&targets.Back()},
                               .constants = ConstantBytes(constants)});
                targets.Swap();
                from = &targets.Front();
            }
        }
        return *from;
    });
}

// Erratum: the two boundary set-ups are not equivalent. Clamping to the edge counts the rim again and again; with a
// black frame of one texel it sums right, but the table has another extent and every entry lies one texel further on.
TEST(Boundary, ClampToEdgeNeedsABlackFrameAndMovesTheTable) {
    const Extent2D extent{10, 7};
    const Extent2D framed{12, 9};
    const Texels source = RandomCodes(extent, 22);
    Texels inFrame(framed.Texels(), glm::vec4(0));
    for (uint32_t y = 0; y < 7; y++)
        for (uint32_t x = 0; x < 10; x++)
            inFrame[12 * (y + 1) + x + 1] = source[10 * y + x];
    const auto expected = reference::SummedAreaTable(ToDouble(extent, source));

    const Texels clamped = BuildWithClampToEdge(extent, source);
    EXPECT_GT(clamped.back().x, expected.texels.back().x);
    const Texels framedTable = BuildWithClampToEdge(framed, inFrame);
    for (uint32_t y = 0; y < 7; y++)
        for (uint32_t x = 0; x < 10; x++)
            ASSERT_EQ(glm::dvec4(framedTable[12 * (y + 1) + x + 1]), expected.texels[10 * y + x]) << x << ", " << y;
}

}  // namespace
}  // namespace boxcar
