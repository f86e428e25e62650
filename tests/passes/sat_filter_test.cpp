// Reading the table on the device against the definition of the mean over a box, in double.
#include "runtime/passes/sat_filter.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numbers>

#include "passes_shaders.h"
#include "runtime/passes/blur.h"
#include "runtime/passes/summed_area_table.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/reference/order.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtents[] = {{1, 1}, {1, 6}, {6, 1}, {12, 19}, {49, 2}, {100, 300}, {256, 256}, {1000, 667}};
constexpr double kUnit = 0x1p-24;

std::vector<glm::vec2> SizesFor(Extent2D extent) {
    std::vector<glm::vec2> sizes;
    for (const float width : {0.25f, 1.0f, 2.0f, 3.0f, 4.5f, 5.0f, 9.0f, 33.0f, 129.0f})
        sizes.emplace_back(width);
    sizes.emplace_back(3.0f, 17.5f);
    sizes.emplace_back(2 * extent.widthTexels, 2 * extent.heightTexels);
    return sizes;
}

// All texels of a small image; of a large one its rim's corners and random ones.
std::vector<glm::ivec2> PlacesIn(Extent2D extent) {
    const int width = static_cast<int>(extent.widthTexels), height = static_cast<int>(extent.heightTexels);
    std::vector<glm::ivec2> places;
    if (extent.Texels() <= 400) {
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
                places.emplace_back(x, y);
        return places;
    }
    places = {{0, 0}, {width - 1, 0}, {0, height - 1}, {width - 1, height - 1}, {width / 2, 0}, {0, height / 2}};
    std::mt19937 random(8);
    for (int i = 0; i < 150; i++)
        places.emplace_back(random() % width, random() % height);
    return places;
}

// What sat.hlsli documents: rounding of the table's entries (four corners, each a tree of that depth), and of the
// lookup.
double ErrorBound(Extent2D extent, double magnitudes, double areaTexels) {
    const double depth = std::bit_width(extent.widthTexels - 1) + std::bit_width(extent.heightTexels - 1);
    return (4 * depth + 20) * kUnit * magnitudes / areaTexels;
}

Texels BlurOnDevice(Extent2D extent, const Texels& source, glm::vec2 size, SATEdge edge, uint32_t taps = 4,
                    glm::vec4 bias = glm::vec4(0)) {
    SummedAreaTable table(TestDevice(), {.extent = extent, .taps = taps});
    SATFilter filter(TestDevice(), {.extent = extent, .edge = edge});
    const Image biasTexel = Upload({1, 1}, Texels(1, bias));
    return RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
        return filter.Record(commands, table.Record(commands, image, &biasTexel), size, &biasTexel);
    });
}

struct EdgePair {
    SATEdge ours;
    reference::Edge theirs;
};
constexpr EdgePair kEdges[] = {{SATEdge::Clip, reference::Edge::Clip}, {SATEdge::Zero, reference::Edge::Zero}};

TEST(SATFilter, IsWithinTheDocumentedBoundOfTheDefinition) {
    for (const Extent2D extent : kExtents) {
        const Texels source = RandomValues(extent, 11);
        const auto reference = ToDouble(extent, source);
        const double magnitudes = static_cast<double>(extent.Texels());  // values are below 1
        for (const glm::vec2 size : SizesFor(extent)) {
            for (const EdgePair edge : kEdges) {
                const Texels blurred = BlurOnDevice(extent, source, size, edge.ours);
                for (const glm::ivec2 at : PlacesIn(extent)) {
                    const glm::dvec4 expected =
                        reference::BoxMean(reference, at.x + 0.5, at.y + 0.5, size.x, size.y, edge.theirs);
                    // At the rim about half of the box is left on an axis.
                    const double columns = std::max(1.0, std::min<double>(size.x, extent.widthTexels) / 2);
                    const double rows = std::max(1.0, std::min<double>(size.y, extent.heightTexels) / 2);
                    const double bound = ErrorBound(extent, magnitudes, columns * rows);
                    for (int c = 0; c < 4; c++)
                        ASSERT_NEAR(blurred[at.y * extent.widthTexels + at.x][c], expected[c], bound)
                            << extent.widthTexels << " x " << extent.heightTexels << ", box " << size.x << " x "
                            << size.y << " round " << at.x << ", " << at.y;
                }
            }
        }
    }
}

// Whole codes up to 256 x 256 give an exact table; then whole-texel boxes have nothing left to round but the
// division.
TEST(SATFilter, OddWidthsOnWholeCodesAreTheCorrectlyRoundedQuotient) {
    for (const Extent2D extent : kExtents) {
        if (extent.Texels() > 256 * 256) continue;
        const Texels source = RandomCodes(extent, 12);
        const auto reference = ToDouble(extent, source);
        for (const float width : {1.0f, 3.0f, 5.0f, 9.0f, 33.0f, 129.0f}) {
            const Texels blurred = BlurOnDevice(extent, source, {width, width}, SATEdge::Clip);
            for (const glm::ivec2 at : PlacesIn(extent)) {
                const auto expected = glm::vec4(
                    reference::BoxMean(reference, at.x + 0.5, at.y + 0.5, width, width, reference::Edge::Clip));
                const glm::vec4 actual = blurred[at.y * extent.widthTexels + at.x];
                for (int c = 0; c < 4; c++)  // Vulkan's division may be off by 2.5 ULP
                    ASSERT_NEAR(actual[c], expected[c], 3 * 0x1p-23 * expected[c])
                        << extent.widthTexels << " x " << extent.heightTexels << ", width " << width << " at " << at.x
                        << ", " << at.y;
            }
        }
    }
}

// Erratum: the papers' "1-bit filter kernel" is one texel, and it is the identity.
TEST(SATFilter, WidthOneReturnsThePicture) {
    for (const Extent2D extent : kExtents) {
        if (extent.Texels() > 256 * 256) continue;
        const Texels source = RandomCodes(extent, 13);
        for (const float width : {1.0f, 0.5f, 1e-30f})
            for (const EdgePair edge : kEdges)
                EXPECT_EQ(BlurOnDevice(extent, source, {width, width}, edge.ours), source)
                    << extent.widthTexels << " x " << extent.heightTexels << ", width " << width;
    }
}

TEST(SATFilter, AConstantPictureStaysConstantToItsRim) {
    for (const Extent2D extent : kExtents) {
        const Texels source(extent.Texels(), glm::vec4(0.3f, 1, 200, 1e-3f));
        for (const glm::vec2 size : SizesFor(extent)) {
            const Texels exact = BlurOnDevice(extent, source, size, SATEdge::Clip, 4, source[0]);
            EXPECT_EQ(exact, source) << "less its mean: " << extent.widthTexels << " x " << extent.heightTexels;
            const Texels codes(extent.Texels(), glm::vec4(200));
            if (extent.Texels() > 256 * 256) continue;
            for (const glm::vec4& texel : BlurOnDevice(extent, codes, size, SATEdge::Clip))
                ASSERT_NEAR(texel.x, 200, 200 * 4 * 0x1p-23) << extent.widthTexels << " x " << extent.heightTexels;
        }
    }
}

TEST(SATFilter, TwiceTheExtentIsTheMeanOfItAll) {
    const Extent2D extent{100, 300};
    const Texels source = RandomCodes(extent, 14);
    glm::dvec4 sum(0);
    for (const glm::vec4& texel : source)
        sum += glm::dvec4(texel);
    const Texels blurred = BlurOnDevice(extent, source, {200, 600}, SATEdge::Clip);
    for (const glm::vec4& texel : blurred)
        ASSERT_NEAR(texel.x, sum.x / 30000, 3 * 0x1p-23 * 255);
}

// Worked by hand: of the box [-1, 2) round texel 0, [0, 2) is inside: (4 + 10) / 2.
TEST(SATFilter, BoxAcrossTheLeftEdgeAveragesOnlyTheVisiblePart) {
    const Texels source = {glm::vec4(4), glm::vec4(10), glm::vec4(100)};
    EXPECT_EQ(BlurOnDevice({3, 1}, source, {3, 1}, SATEdge::Clip)[0], glm::vec4(7));
}

// Erratum (Crow): truncated coordinates with the area of the whole box are zero padding: (4 + 10 + 0) / 3.
TEST(SATFilter, ZeroEdgeDividesByTheWholeBox) {
    const Texels source = {glm::vec4(4), glm::vec4(11), glm::vec4(100)};
    EXPECT_EQ(BlurOnDevice({3, 1}, source, {3, 1}, SATEdge::Zero)[0], glm::vec4(5));
}

// Worked by hand: [0.5, 2.5) round texel 1 takes half of texel 0, all of 1, half of 2.
TEST(SATFilter, AnEvenWidthTakesHalfATexelAtEachEnd) {
    const Texels source = {glm::vec4(4), glm::vec4(10), glm::vec4(100)};
    EXPECT_EQ(BlurOnDevice({3, 1}, source, {2, 1}, SATEdge::Clip)[1], glm::vec4((2 + 10 + 50) / 2.0f));
}

TEST(SATFilter, BiasComesBackOverTheAreaThatCarriedIt) {
    const Extent2D extent{60, 40};
    const Texels source = RandomCodes(extent, 15);
    const glm::vec4 bias(128, 17, 0, 255);
    for (const EdgePair edge : kEdges) {
        const Texels without = BlurOnDevice(extent, source, {9, 4.5f}, edge.ours);
        const Texels with = BlurOnDevice(extent, source, {9, 4.5f}, edge.ours, 4, bias);
        for (size_t i = 0; i < with.size(); i++)
            for (int c = 0; c < 4; c++)
                ASSERT_NEAR(with[i][c], without[i][c], 255 * 8 * 0x1p-23) << "texel " << i;
    }
}

TEST(SATFilter, EveryTapsGivesTheSamePicture) {
    const Extent2D extent{100, 300};
    const Texels source = RandomValues(extent, 16);
    const Texels two = BlurOnDevice(extent, source, {4.5f, 4.5f}, SATEdge::Clip, 2);
    for (const uint32_t taps : {4u, 8u, 16u})
        EXPECT_EQ(BlurOnDevice(extent, source, {4.5f, 4.5f}, SATEdge::Clip, taps), two) << taps << " taps";
}

// SATSampleBox and SATSampleBoxZero, by uv, with centres that are no texel's.
TEST(SATSampleBox, AgreesWithTheDefinitionAtAnyCentre) {
    for (const Extent2D extent : {Extent2D{12, 19}, Extent2D{49, 2}, Extent2D{100, 300}}) {
        const Texels source = RandomValues(extent, 17);
        const auto reference = ToDouble(extent, source);
        for (const EdgePair edge : kEdges) {
            const Pipeline pipeline(
                TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                               test_support_shaders::Find(edge.ours == SATEdge::Zero
                                                              ? "shaders/sat_sample_box.ps.SAMPLE=SATSampleBoxZero"
                                                              : "shaders/sat_sample_box.ps.SAMPLE=SATSampleBox")});
            const Image result(TestDevice(), {extent, Format::RGBA32F, "sampled"});
            SummedAreaTable table(TestDevice(), {.extent = extent});
            for (const glm::vec2 offset : {glm::vec2(0), glm::vec2(0.375f, -0.25f), glm::vec2(-30, 3.5f)}) {
                for (const glm::vec2 size : {glm::vec2(1), glm::vec2(2.75f, 6), glm::vec2(33)}) {
                    const SampleConstants constants{{extent.widthTexels, extent.heightTexels}, size, offset};
                    const Texels sampled =
                        RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
                            commands.Draw({.name = "sample",
                                           .pipeline = pipeline,
                                           .reads = {{"table", table.Record(commands, image).low}},
                                           .writes = {&result},
                                           .constants = ConstantBytes(constants)});
                            return result;
                        });
                    for (const glm::ivec2 at : PlacesIn(extent)) {
                        const double x = at.x + 0.5 + offset.x, y = at.y + 0.5 + offset.y;
                        const double inside = std::max(0.0, std::min<double>(extent.widthTexels, x + size.x / 2) -
                                                                std::max(0.0, x - size.x / 2)) *
                                              std::max(0.0, std::min<double>(extent.heightTexels, y + size.y / 2) -
                                                                std::max(0.0, y - size.y / 2));
                        const double area = edge.ours == SATEdge::Zero ? size.x * size.y : inside;
                        if (area > 0 && area < 0.25) continue;  // a sliver, which the bound does not speak of
                        // uv is rounded, so the centre is off by up to u x side.
                        const double uvError = 4 * kUnit * std::max(extent.widthTexels, extent.heightTexels);
                        const double bound =
                            ErrorBound(extent, static_cast<double>(extent.Texels()), std::max(area, 0.25)) + uvError;
                        const glm::dvec4 expected = reference::BoxMean(reference, x, y, size.x, size.y, edge.theirs);
                        for (int c = 0; c < 4; c++)
                            ASSERT_NEAR(sampled[at.y * extent.widthTexels + at.x][c], expected[c], bound)
                                << "box " << size.x << " x " << size.y << " round " << x << ", " << y;
                    }
                }
            }
        }
    }
}

// Over 5 periods and more, left of the picture and right of it. The bound's S is that of all the periods the box
// reaches.
TEST(SATFilter, RepeatedAndMirroredPicturesAreTheTiledOnes) {
    for (const Extent2D extent : {Extent2D{1, 1}, Extent2D{5, 7}, Extent2D{12, 19}, Extent2D{49, 2}}) {
        const Texels source = RandomValues(extent, 18);
        const auto reference = ToDouble(extent, source);
        for (const auto& [ours, theirs] : {std::pair(SATEdge::Repeat, reference::Border::Repeat),
                                           std::pair(SATEdge::Mirror, reference::Border::Mirror)}) {
            for (const glm::vec2 size : {glm::vec2(1), glm::vec2(3.5f, 8), glm::vec2(60, 2.25f), glm::vec2(101)}) {
                const Texels blurred = BlurOnDevice(extent, source, size, ours);
                const double periods = (size.x / static_cast<float>(extent.widthTexels) + 2) *
                                       (size.y / static_cast<float>(extent.heightTexels) + 2);
                const double bound =
                    ErrorBound(extent, periods * static_cast<double>(extent.Texels()), size.x * size.y);
                for (const glm::ivec2 at : PlacesIn(extent)) {
                    const glm::dvec4 expected =
                        reference::FilterMean(reference, 1, at.x + 0.5, at.y + 0.5, size.x, size.y, theirs);
                    for (int c = 0; c < 4; c++)
                        ASSERT_NEAR(blurred[at.y * extent.widthTexels + at.x][c], expected[c], bound)
                            << extent.widthTexels << " x " << extent.heightTexels << ", box " << size.x << " x "
                            << size.y << " round " << at.x << ", " << at.y;
                }
            }
        }
    }
}

// By uv far outside [0, 1].
TEST(SATSampleBox, RepeatTakesAnyUv) {
    const Extent2D extent{12, 19};
    const Texels source = RandomCodes(extent, 19);
    const auto reference = ToDouble(extent, source);
    const Pipeline pipeline(TestDevice(),
                            {passes_shaders::Find("shaders/quad.vs"),
                             test_support_shaders::Find("shaders/sat_sample_box.ps.SAMPLE=SATSampleBoxRepeat")});
    const Image result(TestDevice(), {extent, Format::RGBA32F, "sampled"});
    SummedAreaTable table(TestDevice(), {.extent = extent});
    for (const glm::vec2 offset : {glm::vec2(0), glm::vec2(-66, 3), glm::vec2(1234, -987)}) {
        const SampleConstants constants{{12, 19}, {7, 50}, offset};
        const Texels sampled =
            RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
                commands.Draw({.name = "sample",
                               .pipeline = pipeline,
                               .reads = {{"table", table.Record(commands, image).low}},
                               .writes = {&result},
                               .constants = ConstantBytes(constants)});
                return result;
            });
        for (const glm::ivec2 at : PlacesIn(extent)) {
            const glm::dvec4 expected = reference::FilterMean(
                reference, 1, at.x + 0.5 + offset.x, at.y + 0.5 + offset.y, 7, 50, reference::Border::Repeat);
            for (int c = 0; c < 4; c++)  // a uv of 100 is rounded by 4e-6, 1e-4 texels
                ASSERT_NEAR(sampled[at.y * 12 + at.x][c], expected[c], 255 * 2e-4) << at.x << ", " << at.y;
        }
    }
}

// Crow 1984: a texture repeated over a plane, each pixel filtered over the larger of its increments in u and in v.
// The reference walks scan lines and adds the increments up, as his does; several periods of the texture lie in a
// pixel.
TEST(Footprint, AScanLineOfIncrementsGivesTheSamePicture) {
    const Extent2D extent{12, 19}, screen{40, 30};
    const Texels source = RandomCodes(extent, 34);
    const auto reference = ToDouble(extent, source);
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/textured_plane.ps")});
    SummedAreaTable table(TestDevice(), {.extent = extent});
    const Image result(TestDevice(), {screen, Format::RGBA32F, "plane"});
    for (const PlaneConstants& plane : {PlaneConstants{{0.25f, -0.0625f}, {0.125f, 0.5f}, {-3, 2}, {12, 19}},
                                        PlaneConstants{{2.5f, 0.03125f}, {0.5f, 1.25f}, {0.5f, -7}, {12, 19}}}) {
        const Image image = Upload(extent, source);
        CommandList commands(TestDevice());
        const Image& sums = *table.Record(commands, image).low;
        commands.Draw({.name = "plane",
                       .pipeline = pipeline,
                       .reads = {{"table", &sums}},
                       .writes = {&result},
                       .constants = ConstantBytes(plane)});
        commands.SubmitAndWait();
        const Texels drawn = Download(result);
        const glm::dvec2 across(plane.acrossUv), down(plane.downUv);
        const glm::dvec2 rectangle = glm::max(glm::abs(across), glm::abs(down)) * glm::dvec2(12, 19);
        glm::dvec2 lineUv = glm::dvec2(plane.startUv) + 0.5 * (across + down);
        for (uint32_t y = 0; y < screen.heightTexels; y++, lineUv += down) {
            glm::dvec2 uv = lineUv;
            for (uint32_t x = 0; x < screen.widthTexels; x++, uv += across) {
                const glm::dvec4 expected = reference::FilterMean(reference, 1, uv.x * 12, uv.y * 19, rectangle.x,
                                                                  rectangle.y, reference::Border::Repeat);
                for (int c = 0; c < 4; c++)
                    ASSERT_NEAR(drawn[y * screen.widthTexels + x][c], expected[c], 255 * 1e-4) << x << ", " << y;
            }
        }
    }
}

// Image loads of a shader, counted in its SPIR-V.
size_t LoadsIn(const EmbeddedShader& shader) {
    constexpr uint32_t kOpImageFetch = 95, kHeaderWords = 5;
    size_t loads = 0;
    for (size_t at = kHeaderWords; at < shader.spirv.size(); at += shader.spirv[at] >> 16)
        loads += (shader.spirv[at] & 0xffff) == kOpImageFetch;
    return loads;
}

// Crow 1984, table of costs: 16 reads of the table with interpolated corners, 4 without.
TEST(Costs, LoadsAreAsDocumented) {
    EXPECT_EQ(LoadsIn(test_support_shaders::Find("shaders/sat_sample_box.ps.SAMPLE=SATSampleBox")), 16u);
    // One more for the list of boxes.
    EXPECT_EQ(LoadsIn(test_support_shaders::Find("shaders/sat_sum_texels.ps.WORDS=1.EDGE=SAT_EDGE_CLIP")), 4u + 1);
    EXPECT_EQ(LoadsIn(test_support_shaders::Find("shaders/sat_sum_texels.ps.WORDS=2.EDGE=SAT_EDGE_CLIP")), 8u + 1);
    for (const uint32_t taps : {2u, 4u, 8u, 16u})
        EXPECT_EQ(LoadsIn(passes_shaders::Find(fmt::format("shaders/sat_pass_load.ps.TAPS={}", taps))), taps);
}

TEST(SATFilter, SumsFromAnywhereGiveTheSameMeans) {
    for (const Extent2D extent : kExtents) {
        const Texels source = RandomValues(extent, 20);
        const auto reference = ToDouble(extent, source);
        for (const SATOrigin origin : {SATOrigin::Center, SATOrigin::LowerLeft}) {
            for (const EdgePair edge : kEdges) {
                for (const glm::vec2 size : {glm::vec2(1), glm::vec2(3, 17.5f), glm::vec2(33)}) {
                    SummedAreaTable table(TestDevice(), {.extent = extent, .origin = origin});
                    SATFilter filter(TestDevice(), {.extent = extent, .edge = edge.ours, .origin = origin});
                    const Texels blurred =
                        RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
                            return filter.Record(commands, table.Record(commands, image), size);
                        });
                    for (const glm::ivec2 at : PlacesIn(extent)) {
                        const glm::dvec4 expected =
                            reference::BoxMean(reference, at.x + 0.5, at.y + 0.5, size.x, size.y, edge.theirs);
                        const double area = std::max(1.0, std::min<double>(size.x, extent.widthTexels) / 2) *
                                            std::max(1.0, std::min<double>(size.y, extent.heightTexels) / 2);
                        for (int c = 0; c < 4; c++)
                            ASSERT_NEAR(blurred[at.y * extent.widthTexels + at.x][c], expected[c],
                                        ErrorBound(extent, static_cast<double>(extent.Texels()), area))
                                << extent.widthTexels << " x " << extent.heightTexels << ", box " << size.x << " x "
                                << size.y << " round " << at.x << ", " << at.y;
                    }
                }
            }
        }
    }
}

TEST(SATFilter, DiscsAndMapsWorkOnFloatsToo) {
    const Extent2D extent{40, 33};
    const Texels source = RandomCodes(extent, 22);
    const auto reference = ToDouble(extent, source);
    Texels widths;
    for (uint64_t i = 0; i < extent.Texels(); i++)
        widths.emplace_back(static_cast<float>(i % 40) / 39, 0, 0, 0);
    const Image map = Upload(extent, widths);
    SummedAreaTable table(TestDevice(), {.extent = extent});
    for (const EdgePair edge : kEdges) {
        SATFilter filter(TestDevice(), {.extent = extent, .boxes = 7, .edge = edge.ours});
        const Texels blurred =
            RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
                return filter.Record(commands, table.Record(commands, image), SATWidths(map, {1, 1}, {21, 21}));
            });
        const auto border = edge.ours == SATEdge::Clip ? reference::Border::Clip : reference::Border::Zero;
        for (const glm::ivec2 at : PlacesIn(extent)) {
            const glm::dvec4 expected =
                reference::DiscMean(reference, at.x + 0.5, at.y + 0.5, 1 + 20.0 * at.x / 39, 7, border);
            for (int c = 0; c < 4; c++)
                ASSERT_NEAR(blurred[at.y * 40 + at.x][c], expected[c], 255 * 2e-5) << at.x << ", " << at.y;
        }
    }
}

// hlsl/boxcar/sat.hlsli says how much larger than the disc its boxes are.
TEST(SATFilter, TheBoxesOfADiscHaveAlmostItsArea) {
    const auto excess = [](int boxes) {
        double area = 0;
        for (int k = 0; k < boxes; k++) {
            const double middle = (2 * k + 1.0) / boxes - 1;
            area += std::sqrt(1 - middle * middle) / boxes;
        }
        return area / (std::numbers::pi / 4) - 1;
    };
    EXPECT_NEAR(excess(8), 0.013, 5e-4);
    EXPECT_NEAR(excess(16), 0.005, 5e-4);
}

// Properties that need no reference, under random draws.

TEST(SATFilterProperty, AShiftedPictureGivesTheShiftedMeans) {
    const Extent2D extent{60, 40};
    std::mt19937 random(23);
    for (int draw = 0; draw < 4; draw++) {
        const int dx = static_cast<int>(random() % 60), dy = static_cast<int>(random() % 40);
        const Texels source = RandomCodes(extent, 24 + static_cast<uint32_t>(draw));
        Texels shifted(source.size());
        for (int y = 0; y < 40; y++)
            for (int x = 0; x < 60; x++)
                shifted[static_cast<size_t>((y + dy) % 40 * 60 + (x + dx) % 60)] =
                    source[static_cast<size_t>(y * 60 + x)];
        const glm::vec2 size(glm::ivec2(1 + static_cast<int>(random() % 20), 1 + static_cast<int>(random() % 20)));
        const Texels a = BlurOnDevice(extent, source, size, SATEdge::Repeat);
        const Texels b = BlurOnDevice(extent, shifted, size, SATEdge::Repeat);
        for (int y = 0; y < 40; y++)
            for (int x = 0; x < 60; x++)
                ASSERT_NEAR(b[static_cast<size_t>((y + dy) % 40 * 60 + (x + dx) % 60)].x,
                            a[static_cast<size_t>(y * 60 + x)].x, 255 * 4e-7)
                    << "moved by " << dx << ", " << dy;
    }
}

TEST(SATFilterProperty, TheMeanOfASumIsTheSumOfTheMeans) {
    const Extent2D extent{60, 40};
    for (const SATEdge edge : {SATEdge::Clip, SATEdge::Zero, SATEdge::Repeat, SATEdge::Mirror}) {
        const Texels a = RandomCodes(extent, 30), b = RandomCodes(extent, 31);
        Texels both;
        for (size_t i = 0; i < a.size(); i++)
            both.push_back(2.0f * a[i] - b[i]);
        const Texels meanA = BlurOnDevice(extent, a, {5, 9.5f}, edge),
                     meanB = BlurOnDevice(extent, b, {5, 9.5f}, edge);
        const Texels mean = BlurOnDevice(extent, both, {5, 9.5f}, edge);
        for (size_t i = 0; i < a.size(); i++)
            ASSERT_NEAR(mean[i].y, 2 * meanA[i].y - meanB[i].y, 255 * 2e-6) << "texel " << i;
    }
}

// Where the picture goes on for ever, a filter moves light about and neither makes nor loses any.
TEST(SATFilterProperty, RepeatedAndMirroredPicturesKeepTheirEnergy) {
    const Extent2D extent{61, 40};
    const Texels source = RandomCodes(extent, 32);
    const auto energy = [](const Texels& texels) {
        double sum = 0;
        for (const glm::vec4& texel : texels)
            sum += texel.z;
        return sum;
    };
    for (const SATEdge edge : {SATEdge::Repeat, SATEdge::Mirror})
        for (const glm::vec2 size : {glm::vec2(3, 5), glm::vec2(7.5f, 22), glm::vec2(130, 1)})
            EXPECT_NEAR(energy(BlurOnDevice(extent, source, size, edge)) / energy(source), 1, 1e-6);
}

TEST(SATFilterProperty, AMirroredPictureGivesTheMirroredMeans) {
    const Extent2D extent{45, 38};
    const Texels source = RandomCodes(extent, 33);
    Texels turned(source.rbegin(), source.rend());
    for (const SATEdge edge : {SATEdge::Clip, SATEdge::Zero, SATEdge::Repeat, SATEdge::Mirror}) {
        const Texels a = BlurOnDevice(extent, source, {9, 4.5f}, edge),
                     b = BlurOnDevice(extent, turned, {9, 4.5f}, edge);
        for (size_t i = 0; i < a.size(); i++)
            ASSERT_NEAR(a[i].x, b[b.size() - 1 - i].x, 255 * 1e-6) << "texel " << i;
    }
}

TEST(SATFilter, RefusesWhatItCannotDo) {
    const Extent2D extent{4, 4};
    EXPECT_ERROR(SATFilter(TestDevice(), {.extent = extent, .order = 2}),
                 "order 2 in floats: tents and parabolic kernels need integers");
    EXPECT_ERROR(SATFilter(TestDevice(), {.extent = extent, .precision = SATPrecision::U32, .order = 4}),
                 "order 4: kernels are of order 1, 2 or 3");
    EXPECT_ERROR(SATFilter(TestDevice(), {.extent = extent, .precision = SATPrecision::U32, .order = 2, .boxes = 3}),
                 "a disc of 3 boxes is of order 1, not 2");
    EXPECT_ERROR(SATFilter(TestDevice(), {.extent = extent, .edge = SATEdge::Repeat, .origin = SATOrigin::Center}),
                 "integers and repeated images need sums that start at the upper left corner");
    EXPECT_ERROR(SATFilter(TestDevice(),
                           {.extent = extent, .precision = SATPrecision::U64, .order = 3, .edge = SATEdge::Mirror}),
                 "order 3 over a repeated image: extend the image first (ExtendedImage)");
}

}  // namespace
}  // namespace boxcar
