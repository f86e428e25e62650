// Tables of integers, and all that is read from them, against references in 128-bit integers and in double.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "hlsl/boxcar/sat_range.h"
#include "passes_shaders.h"
#include "runtime/passes/blur.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/reference/separable.h"
#include "tests/support/device_codes.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

using reference::Border;

constexpr Extent2D kExtents[] = {{1, 1}, {1, 6}, {6, 1}, {12, 19}, {49, 2}, {100, 300}, {257, 31}};
constexpr SATPrecision kExact[] = {SATPrecision::U32, SATPrecision::U64};
constexpr int64_t kHalfLargest = int64_t{65504} << 24;

struct EdgePair {
    SATEdge ours;
    Border theirs;
};
constexpr EdgePair kEdges[] = {{SATEdge::Clip, Border::Clip},
                               {SATEdge::Zero, Border::Zero},
                               {SATEdge::Repeat, Border::Repeat},
                               {SATEdge::Mirror, Border::Mirror}};

// As many words as there are, one 64-bit number a channel.
std::vector<std::array<uint64_t, 4>> DownloadSums(TexelWords words) {
    std::vector<std::array<uint64_t, 4>> sums;
    for (const glm::uvec4& low : DownloadWords(*words.low))
        sums.push_back({low.x, low.y, low.z, low.w});
    if (words.high) {
        size_t i = 0;
        for (const glm::uvec4& high : DownloadWords(*words.high)) {
            for (int c = 0; c < 4; c++)
                sums[i][static_cast<size_t>(c)] |= uint64_t{high[c]} << 32;
            i++;
        }
    }
    return sums;
}

std::vector<std::array<uint64_t, 4>> TableOf(const reference::CodeImage& image, SATPrecision precision,
                                             uint32_t order, uint32_t taps) {
    const DeviceCodes codes(image, precision);
    SummedAreaTable table(TestDevice(),
                          {.extent = codes.images[0].Extent(), .precision = precision, .order = order, .taps = taps});
    CommandList commands(TestDevice());
    const TexelWords sums = table.Record(commands, codes.Words());
    commands.SubmitAndWait();
    return DownloadSums(sums);
}

size_t WrongEntries(const std::vector<std::array<uint64_t, 4>>& actual, const reference::WideImage& expected,
                    SATPrecision precision) {
    size_t wrong = 0;
    for (size_t i = 0; i < actual.size(); i++)
        for (size_t c = 0; c < 4; c++)
            wrong += static_cast<__int128>(actual[i][c]) !=
                     reference::WrapTo(expected.texels[i][c], precision == SATPrecision::U64 ? 64 : 32);
    return wrong;
}

TEST(ExactTable, EntriesOfEveryOrderAreTheRepeatedSumsModuloTheirWords) {
    for (const Extent2D extent : kExtents) {
        for (const SATPrecision precision : kExact) {
            // Codes as large as they come, so that the tables wrap.
            const bool isWide = precision == SATPrecision::U64;
            const auto image = isWide ? RandomCodeImage(extent, 31, -kHalfLargest, kHalfLargest)
                                      : RandomCodeImage(extent, 31, 0, 0xffffffff);
            for (uint32_t order = 1; order <= 3; order++) {
                const auto expected = reference::RepeatedTable(image, static_cast<int>(order));
                for (const uint32_t taps : {2u, 4u, 8u, 16u})
                    EXPECT_EQ(WrongEntries(TableOf(image, precision, order, taps), expected, precision), 0u)
                        << extent.widthTexels << " x " << extent.heightTexels << ", order " << order << ", " << taps
                        << " taps, " << 32 * WordsOf(precision) << " bits";
            }
        }
    }
}

TEST(ExactTable, NothingOfAnEarlierPictureIsLeftInATableOfAnyOrder) {
    const Extent2D extent{37, 70};
    for (uint32_t order = 1; order <= 3; order++) {
        SummedAreaTable table(TestDevice(), {.extent = extent, .precision = SATPrecision::U64, .order = order});
        for (const uint32_t seed : {32u, 33u, 34u}) {
            const auto image = RandomCodeImage(extent, seed, 0, 65535);
            const DeviceCodes codes(image, SATPrecision::U64);
            CommandList commands(TestDevice());
            const TexelWords sums = table.Record(commands, codes.Words());
            commands.SubmitAndWait();
            EXPECT_EQ(WrongEntries(DownloadSums(sums), reference::RepeatedTable(image, static_cast<int>(order)),
                                   SATPrecision::U64),
                      0u);
        }
    }
}

// Sums over whole texels of `boxes`: (lo.x, lo.y, hi.x, hi.y).
std::vector<std::array<uint64_t, 4>> SumsOf(const reference::CodeImage& image, SATPrecision precision,
                                            const std::vector<glm::ivec4>& boxes, Extent2D boxesExtent,
                                            const char* edge) {
    const DeviceCodes codes(image, precision);
    const Extent2D extent = codes.images[0].Extent();
    SummedAreaTable table(TestDevice(), {.extent = extent, .precision = precision});
    const Image boxImage = UploadWords(boxesExtent, {boxes.begin(), boxes.end()});
    const uint32_t words = WordsOf(precision);
    const std::string name = fmt::format("shaders/sat_sum_texels.ps.WORDS={}.EDGE={}", words, edge);
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"), test_support_shaders::Find(name),
                                           std::vector(words, Format::RGBA32UI)});
    const Image low(TestDevice(), {boxesExtent, Format::RGBA32UI, "low"});
    const Image high(TestDevice(), {boxesExtent, Format::RGBA32UI, "high"});
    CommandList commands(TestDevice());
    const TexelWords sums = table.Record(commands, codes.Words());
    const SampleConstants constants{{extent.widthTexels, extent.heightTexels}, {}, {}};
    Pass pass{.name = "sum",
              .pipeline = pipeline,
              .reads = {{"table", sums.low}, {"boxes", &boxImage}},
              .writes = {&low},
              .constants = ConstantBytes(constants)};
    if (words == 2) {
        pass.reads.push_back({"tableHigh", sums.high});
        pass.writes.push_back(&high);
    }
    commands.Draw(pass);
    commands.SubmitAndWait();
    return DownloadSums(words == 2 ? TexelWords(low, high) : TexelWords(low));
}

// 4096 x 4096 texels and 1,000,000 boxes: all whose own sum fits come out to the last bit, though the table wraps
// many times over.
TEST(ExactTable, AMillionBoxesOfALargePictureAreExact) {
    constexpr int kSide = 4096;
    constexpr Extent2D kBoxes{1000, 1000};
    for (const SATPrecision precision : kExact) {
        const bool isWide = precision == SATPrecision::U64;
        std::mt19937_64 random(35);
        reference::CodeImage image{kSide, kSide, {}};
        for (int i = 0; i < kSide * kSide; i++) {
            const uint64_t bits = random();
            // 8-bit codes; half floats' codes of up to 40 bits.
            if (isWide)
                image.texels.push_back({static_cast<int64_t>(bits >> 24), static_cast<int64_t>(bits % 99), 1,
                                        static_cast<int64_t>(bits & 0xffffff) << 16});
            else
                image.texels.push_back({static_cast<int64_t>(bits & 255), static_cast<int64_t>(bits >> 8 & 255), 255,
                                        static_cast<int64_t>(bits >> 16 & 255)});
        }
        std::vector<glm::ivec4> boxes;
        for (uint64_t i = 0; i < kBoxes.Texels(); i++) {
            const int x = static_cast<int>(random() % kSide), y = static_cast<int>(random() % kSide);
            boxes.emplace_back(x, y, x + 1 + static_cast<int>(random() % static_cast<uint64_t>(kSide - x)),
                               y + 1 + static_cast<int>(random() % static_cast<uint64_t>(kSide - y)));
        }
        const auto actual = SumsOf(image, precision, boxes, kBoxes, "SAT_EDGE_CLIP");
        const auto table = reference::RepeatedTable(image, 1);
        EXPECT_EQ(WrongEntries(TableOf(image, precision, 1, 4), table, precision), 0u);
        const auto at = [&](int x, int y, size_t c) -> __int128 {
            return x > 0 && y > 0 ? table.At(x - 1, y - 1)[c] : 0;
        };
        size_t wrong = 0, tooLarge = 0;
        for (size_t i = 0; i < boxes.size(); i++) {
            const glm::ivec4 b = boxes[i];
            for (size_t c = 0; c < 4; c++) {
                const __int128 expected = at(b.z, b.w, c) - at(b.x, b.w, c) - at(b.z, b.y, c) + at(b.x, b.y, c);
                if (expected >> (32 * WordsOf(precision)) != 0) {
                    tooLarge++;
                    continue;
                }
                wrong += static_cast<__int128>(actual[i][c]) != expected;
            }
        }
        EXPECT_EQ(wrong, 0u);
        EXPECT_EQ(tooLarge, 0u) << "every box of 8-bit codes up to 16,843,009 texels fits into 32 bits";
    }
}

TEST(ExactTable, RepeatedAndMirroredBoxesOfManyPeriodsAreExact) {
    for (const Extent2D extent : {Extent2D{5, 7}, Extent2D{1, 3}, Extent2D{12, 19}}) {
        const auto image = RandomCodeImage(extent, 36, 0, 255);
        std::mt19937 random(37);
        std::vector<glm::ivec4> boxes;
        for (int i = 0; i < 200; i++) {
            const int x = static_cast<int>(random() % 120) - 60, y = static_cast<int>(random() % 120) - 60;
            boxes.emplace_back(x, y, x + static_cast<int>(random() % 100), y + static_cast<int>(random() % 100));
        }
        for (const auto& [name, border] :
             {std::pair("SAT_EDGE_REPEAT", Border::Repeat), std::pair("SAT_EDGE_MIRROR", Border::Mirror)}) {
            for (const SATPrecision precision : kExact) {
                const auto actual = SumsOf(image, precision, boxes, {200, 1}, name);
                for (size_t i = 0; i < boxes.size(); i++) {
                    uint64_t expected = 0;
                    for (int y = boxes[i].y; y < boxes[i].w; y++)
                        for (int x = boxes[i].x; x < boxes[i].z; x++)
                            expected +=
                                static_cast<uint64_t>(image.At(reference::MapTexel(x, image.width, border),
                                                               reference::MapTexel(y, image.height, border))[1]);
                    ASSERT_EQ(actual[i][1], expected) << name << ", box " << i;
                }
            }
        }
    }
}

Texels BlurCodes(const reference::CodeImage& image, BlurDesc desc, const SATWidths& widths) {
    const DeviceCodes codes(image, desc.precision);
    desc.extent = codes.images[0].Extent();
    desc.largestTexels = widths.maxTexels;
    Blur blur(TestDevice(), desc);
    CommandList commands(TestDevice());
    const Image& result = blur.Record(commands, codes.Words(), widths);
    commands.SubmitAndWait();
    return Download(result);
}

// All texels of a small image; of a large one its rim and random ones.
std::vector<glm::ivec2> PlacesIn(const reference::CodeImage& image) {
    std::vector<glm::ivec2> places;
    std::mt19937 random(38);
    const bool isSmall = image.width * image.height <= 400;
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            const bool isCorner = (x < 3 || x >= image.width - 3) && (y < 3 || y >= image.height - 3);
            if (isSmall || isCorner || random() % 150 == 0) places.emplace_back(x, y);
        }
    return places;
}

// Whole widths: sum and mass are whole numbers, and the mean is their quotient, rounded once.
TEST(SATOrder, WholeWidthsAreTheRepeatedBoxOverTexelsExactly) {
    for (const Extent2D extent : {Extent2D{1, 1}, Extent2D{6, 1}, Extent2D{12, 19}, Extent2D{49, 2}}) {
        const auto image = RandomCodeImage(extent, 39, 0, 255);
        for (uint32_t order = 1; order <= 3; order++) {
            for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(3), glm::ivec2(5, 9), glm::ivec2(2, 4)}) {
                if (order != 2 && size.x % 2 == 0) continue;
                for (const EdgePair edge : kEdges) {
                    const bool isMirrored = edge.ours == SATEdge::Repeat || edge.ours == SATEdge::Mirror;
                    if (order == 1 && isMirrored) continue;
                    for (const SATPrecision precision : kExact) {
                        const Texels blurred = BlurCodes(
                            image,
                            {.precision = precision, .order = order, .edge = edge.ours, .codes = {255, 255, false}},
                            SATWidths(glm::vec2(size)));
                        for (const glm::ivec2 at : PlacesIn(image)) {
                            const auto sum = reference::WholeSum(image, static_cast<int>(order), at.x, at.y, size.x,
                                                                 size.y, edge.theirs);
                            const auto mass = static_cast<double>(reference::WholeMass(
                                image, static_cast<int>(order), at.x, at.y, size.x, size.y, edge.theirs));
                            for (int c = 0; c < 4; c++)
                                ASSERT_EQ(blurred[at.y * extent.widthTexels + at.x][c],
                                          static_cast<float>(static_cast<double>(sum[static_cast<size_t>(c)]) /
                                                             (mass * 255)))
                                    << extent.widthTexels << " x " << extent.heightTexels << ", order " << order
                                    << ", width " << size.x << " x " << size.y << " at " << at.x << ", " << at.y
                                    << ", edge " << static_cast<int>(edge.ours);
                        }
                    }
                }
            }
        }
    }
}

// Erratum: the signs of the second-order filter; all four of the corner weights and the middle one are positive.
TEST(SATOrder, TheTentIsTheBartlettKernelWithItsSignsPutRight) {
    reference::CodeImage impulse{9, 9, {}};
    impulse.texels.assign(81, {0, 0, 0, 0});
    impulse.texels[4 * 9 + 4] = {81, 0, 0, 0};
    const Texels tent = BlurCodes(impulse, {.precision = SATPrecision::U32, .order = 2, .codes = {1, 255, false}},
                                  SATWidths(glm::vec2(3)));
    const float weights[] = {1, 2, 3, 2, 1};
    for (int y = 0; y < 5; y++)
        for (int x = 0; x < 5; x++)
            EXPECT_EQ(tent[(y + 2) * 9 + x + 2].x, weights[x] * weights[y]);
    EXPECT_EQ(tent[1 * 9 + 4].x, 0);
}

// The table is not constant beyond its last texel: clamped addresses would give -341 for 43.
TEST(SATOrder, ATentAtTheRightRimReadsTheTableAsItGoesOn) {
    reference::CodeImage ones{64, 1, {}};
    ones.texels.assign(64, {1, 1, 1, 1});
    const Texels tent =
        BlurCodes(ones, {.precision = SATPrecision::U32, .order = 2, .edge = SATEdge::Zero, .codes = {1, 255, false}},
                  SATWidths(glm::vec2(8, 1)));
    EXPECT_EQ(tent[62].x, 43.0f / 64);
    EXPECT_EQ(tent[20].x, 1.0f);
}

TEST(SATOrder, TentAndParabolicAreTheAnalyticFilter) {
    for (const Extent2D extent : {Extent2D{12, 19}, Extent2D{70, 2}}) {
        const auto image = RandomCodeImage(extent, 40, 0, 255);
        const auto reference = ToDouble(image);
        for (uint32_t order = 1; order <= 3; order++) {
            for (const glm::vec2 size : {glm::vec2(1.0625f), glm::vec2(2.5f, 7.25f), glm::vec2(8.3f, 4)}) {
                for (const EdgePair edge : kEdges) {
                    for (const SATPrecision precision : kExact) {
                        const BlurDesc desc{
                            .precision = precision, .order = order, .edge = edge.ours, .codes = {255, 255, false}};
                        const Texels blurred = BlurCodes(image, desc, SATWidths(size));
                        for (const glm::ivec2 at : PlacesIn(image)) {
                            const glm::dvec4 expected = reference::MeanAt(reference, static_cast<int>(order), at.x,
                                                                          at.y, size.x, size.y, edge.theirs);
                            for (int c = 0; c < 4; c++)
                                ASSERT_NEAR(blurred[at.y * extent.widthTexels + at.x][c], expected[c] / 255, 1e-5)
                                    << extent.widthTexels << " x " << extent.heightTexels << ", order " << order
                                    << ", width " << size.x << " x " << size.y << " at " << at.x << ", " << at.y
                                    << ", edge " << static_cast<int>(edge.ours);
                        }
                    }
                }
            }
        }
    }
}

TEST(SATOrder, TentAndParabolicAreTheAnalyticFilterRoundAnyCentre) {
    const Extent2D extent{160, 90};
    const auto image = RandomCodeImage(extent, 41, 0, 65535);
    const auto reference = ToDouble(image);
    const DeviceCodes codes(image, SATPrecision::U64);
    std::mt19937 random(42);
    for (uint32_t order = 2; order <= 3; order++) {
        SummedAreaTable table(TestDevice(), {.extent = extent, .precision = SATPrecision::U64, .order = order});
        const Pipeline pipeline(TestDevice(),
                                {passes_shaders::Find("shaders/quad.vs"),
                                 test_support_shaders::Find(fmt::format("shaders/sat_order.ps.ORDER={}", order))});
        const Image result(TestDevice(), {extent, Format::RGBA32F, "sampled"});
        for (int draw = 0; draw < 6; draw++) {
            std::uniform_real_distribution<float> width(1, 40), offset(-0.5f, 0.5f);
            const SampleConstants constants{
                {160, 90}, {width(random), width(random)}, {offset(random), offset(random)}};
            CommandList commands(TestDevice());
            const TexelWords sums = table.Record(commands, codes.Words());
            commands.Draw({.name = "sample",
                           .pipeline = pipeline,
                           .reads = {{"table", sums.low}, {"tableHigh", sums.high}},
                           .writes = {&result},
                           .constants = ConstantBytes(constants)});
            commands.SubmitAndWait();
            const Texels sampled = Download(result);
            for (const glm::ivec2 at : PlacesIn(image)) {
                // The centre as the shader gets it, rounded to float.
                const double x = static_cast<float>(at.x) + 0.5f + constants.offsetTexels.x;
                const double y = static_cast<float>(at.y) + 0.5f + constants.offsetTexels.y;
                const glm::dvec4 expected =
                    reference::FilterMean(reference, static_cast<int>(order), x, y, constants.sizeTexels.x,
                                          constants.sizeTexels.y, Border::Clip);
                for (int c = 0; c < 4; c++)
                    ASSERT_NEAR(sampled[at.y * 160 + at.x][c] / 65535, expected[c] / 65535, 1e-5)
                        << "order " << order << ", width " << constants.sizeTexels.x << " x "
                        << constants.sizeTexels.y << " round " << x << ", " << y;
            }
        }
    }
}

// Sixteen-bit codes under kernels of any width, far from the picture's corner too: the mean is off by its last
// rounding to float; by as much again where the widths of a disc's boxes, or the corners of a polygon, are rounded.
TEST(ExactFilter, MeansAreRightToTheLastBit) {
    constexpr double kUnit = 0x1p-24;
    const Extent2D extent{9001, 7};
    reference::CodeImage image = RandomCodeImage(extent, 56, 0, 65535);
    for (size_t i = 0; i < image.texels.size(); i++)  // black and white: where edges count most
        if (image.texels[i][3] % 3 == 0) image.texels[i] = {0, 65535, 65535, 0};
    const auto reference = ToDouble(image);
    const SATCodes codes{65535, 65535, false};
    std::vector<glm::ivec2> places;
    std::mt19937 random(57);
    for (int i = 0; i < 120; i++)
        places.emplace_back(i % 3 == 0 ? 8990 + random() % 11 : random() % 9001, random() % 7);
    for (const glm::vec2 size : {glm::vec2(2.3f), glm::vec2(7.77f, 3.25f), glm::vec2(31.4f)}) {
        for (uint32_t order = 1; order <= 3; order++) {
            for (const EdgePair edge : kEdges) {
                const Texels blurred = BlurCodes(
                    image, {.precision = SATPrecision::U64, .order = order, .edge = edge.ours, .codes = codes}, size);
                const bool isWhole = order > 1 && SATIsWhole(size, order);
                if (isWhole) continue;
                for (const glm::ivec2 at : places) {
                    const glm::dvec4 expected = reference::FilterMean(reference, static_cast<int>(order), at.x + 0.5,
                                                                      at.y + 0.5, size.x, size.y, edge.theirs) /
                                                65535.0;
                    for (int c = 0; c < 4; c++)
                        ASSERT_NEAR(blurred[static_cast<size_t>(at.y) * 9001 + at.x][c], expected[c], 1.5 * kUnit)
                            << "order " << order << ", " << size.x << " x " << size.y << " at " << at.x << ", "
                            << at.y << ", edge " << static_cast<int>(edge.ours);
                }
            }
        }
        for (const uint32_t sides : {0u, 5u, 6u}) {
            const Texels blurred =
                BlurCodes(image, {.precision = SATPrecision::U64, .boxes = 16, .sides = sides, .codes = codes},
                          glm::vec2(size.x));
            for (const glm::ivec2 at : places) {
                const glm::dvec4 expected =
                    (sides == 0 ? reference::DiscMean(reference, at.x + 0.5, at.y + 0.5, size.x, 16, Border::Clip)
                                : reference::PolygonMean(reference, at.x + 0.5, at.y + 0.5, size.x,
                                                         static_cast<int>(sides), 16, Border::Clip)) /
                    65535.0;
                for (int c = 0; c < 4; c++)
                    ASSERT_NEAR(blurred[static_cast<size_t>(at.y) * 9001 + at.x][c], expected[c], 2.5 * kUnit)
                        << sides << " sides, diameter " << size.x << " at " << at.x << ", " << at.y;
            }
        }
    }
}

TEST(ExactFilter, NegativeHalfFloatsKeepTheirSign) {
    const Extent2D extent{30, 20};
    const auto image = RandomCodeImage(extent, 43, -kHalfLargest, kHalfLargest);
    const auto reference = ToDouble(image);
    for (const glm::vec2 size : {glm::vec2(3), glm::vec2(4.5f)}) {
        const Texels blurred = BlurCodes(
            image, {.precision = SATPrecision::U64, .codes = {0x1p24f, static_cast<double>(kHalfLargest), true}},
            SATWidths(size));
        for (const glm::ivec2 at : PlacesIn(image)) {
            const glm::dvec4 expected =
                reference::FilterMean(reference, 1, at.x + 0.5, at.y + 0.5, size.x, size.y, Border::Clip);
            for (int c = 0; c < 4; c++)
                ASSERT_NEAR(blurred[at.y * 30 + at.x][c], expected[c] * 0x1p-24, 65504 * 1e-6);
        }
    }
}

TEST(ExactFilter, DiscsAreTheMeanOverTheirRectangles) {
    const Extent2D extent{40, 33};
    const auto image = RandomCodeImage(extent, 44, 0, 255);
    const auto reference = ToDouble(image);
    for (const EdgePair edge : kEdges) {
        for (const uint32_t boxes : {1u, 5u, 16u}) {
            for (const float diameter : {1.0f, 6.5f, 21.0f, 100.0f}) {
                const BlurDesc desc{
                    .precision = SATPrecision::U32, .boxes = boxes, .edge = edge.ours, .codes = {255, 255, false}};
                const Texels exact = BlurCodes(image, desc, SATWidths(glm::vec2(diameter)));
                for (const glm::ivec2 at : PlacesIn(image)) {
                    // One box is the box itself, as wide as the disc at its middle.
                    const glm::dvec4 expected = reference::DiscMean(reference, at.x + 0.5, at.y + 0.5, diameter,
                                                                    static_cast<int>(boxes), edge.theirs);
                    for (int c = 0; c < 4; c++)
                        ASSERT_NEAR(exact[at.y * 40 + at.x][c], expected[c] / 255, 1e-5)
                            << boxes << " boxes, diameter " << diameter << " at " << at.x << ", " << at.y;
                }
            }
        }
    }
}

TEST(ExactFilter, PolygonsAreTheMeanOverTheirRectangles) {
    const Extent2D extent{40, 33};
    const auto image = RandomCodeImage(extent, 53, 0, 255);
    const auto reference = ToDouble(image);
    for (const uint32_t sides : {3u, 4u, 5u, 6u, 8u}) {
        for (const EdgePair edge : kEdges) {
            const BlurDesc desc{.precision = SATPrecision::U32,
                                .boxes = 9,
                                .sides = sides,
                                .edge = edge.ours,
                                .codes = {255, 255, false}};
            const Texels exact = BlurCodes(image, desc, SATWidths(glm::vec2(17)));
            for (const glm::ivec2 at : PlacesIn(image)) {
                const glm::dvec4 expected = reference::PolygonMean(reference, at.x + 0.5, at.y + 0.5, 17,
                                                                   static_cast<int>(sides), 9, edge.theirs);
                for (int c = 0; c < 4; c++)
                    ASSERT_NEAR(exact[at.y * 40 + at.x][c], expected[c] / 255, 1e-5)
                        << sides << " sides at " << at.x << ", " << at.y;
            }
        }
    }
}

// Crow's saving where a texture is minified: corners at the nearest whole texels. A corner is off by half a texel at
// most, so the mean by (w + h + 1) / (w h) of the range.
TEST(ExactTable, WholeCornersAreEnoughForLargeBoxes) {
    const auto image = RandomCodeImage({200, 150}, 54, 0, 255);
    const auto reference = ToDouble(image);
    std::mt19937 random(55);
    for (const double side : {8.0, 16.0, 32.0, 64.0}) {
        std::vector<glm::ivec4> boxes;
        std::vector<glm::dvec2> centres;
        for (int i = 0; i < 100; i++) {
            std::uniform_real_distribution<double> x(side / 2, 200 - side / 2), y(side / 2, 150 - side / 2);
            centres.emplace_back(x(random), y(random));
            boxes.emplace_back(
                glm::ivec4(glm::round(glm::dvec4(centres.back() - side / 2, centres.back() + side / 2))));
        }
        const auto sums = SumsOf(image, SATPrecision::U32, boxes, {100, 1}, "SAT_EDGE_CLIP");
        double worst = 0;
        for (size_t i = 0; i < boxes.size(); i++) {
            const double area = (boxes[i].z - boxes[i].x) * (boxes[i].w - boxes[i].y);
            const double expected =
                reference::BoxMean(reference, centres[i].x, centres[i].y, side, side, reference::Edge::Clip)[0];
            worst = std::max(worst, std::abs(static_cast<double>(sums[i][0]) / area - expected));
        }
        EXPECT_LE(worst, 255 * (2 * side + 1) / (side * side)) << side;
        EXPECT_GT(worst, 0.01) << "a box between texels is another one";
    }
}

TEST(ExactFilter, AMapGivesEachTexelItsOwnWidth) {
    const Extent2D extent{31, 24};
    const auto image = RandomCodeImage(extent, 45, 0, 255);
    const auto reference = ToDouble(image);
    Texels widths;
    std::mt19937 random(46);
    for (uint64_t i = 0; i < extent.Texels(); i++)
        widths.emplace_back(static_cast<float>(random() % 256) / 255, 0, 0, 0);
    const Image map = Upload(extent, widths);
    for (uint32_t order = 1; order <= 3; order++) {
        const Texels blurred =
            BlurCodes(image, {.precision = SATPrecision::U64, .order = order, .codes = {255, 255, false}},
                      SATWidths(map, {1, 2}, {9, 20}));
        for (const glm::ivec2 at : PlacesIn(image)) {
            const size_t i = static_cast<size_t>(at.y * 31 + at.x);
            const double t = widths[i].x;
            const glm::dvec4 expected = reference::FilterMean(reference, static_cast<int>(order), at.x + 0.5,
                                                              at.y + 0.5, 1 + 8 * t, 2 + 18 * t, Border::Clip);
            for (int c = 0; c < 4; c++)
                ASSERT_NEAR(blurred[i][c], expected[c] / 255, 2e-5) << "order " << order << " at " << at.x;
        }
    }
}

TEST(ExactFilter, TexelsOfAMapThatAreTooWideAreMarkedAndNoOthers) {
    const Extent2D extent{256, 1};
    const auto image = RandomCodeImage(extent, 47, 0, 65535);
    Texels widths;
    for (int x = 0; x < 256; x++)
        widths.emplace_back(static_cast<float>(x) / 255, 0, 0, 0);
    const Image map = Upload(extent, widths);
    const Texels blurred = BlurCodes(image, {.precision = SATPrecision::U32, .codes = {65535, 65535, false}},
                                     SATWidths(map, {1, 256}, {511, 256}));
    for (int x = 0; x < 256; x++)
        EXPECT_EQ(std::isnan(blurred[static_cast<size_t>(x)].x), 1 + 2 * x > 256) << "width " << 1 + 2 * x;
}

TEST(ExactFilter, AWidthThatMayNotFitIsRefusedWithTheLargestThatDoes) {
    const Extent2D extent{8, 8};
    const auto image = RandomCodeImage(extent, 48, 0, 255);
    EXPECT_ERROR(BlurCodes(image, {.precision = SATPrecision::U32, .order = 2, .codes = {255, 255, false}},
                           SATWidths(glm::vec2(65))),
                 "a tent of 65 x 65 texels over codes up to 255 may not fit into 32 bits: u32 holds 64 x 64");
    EXPECT_NO_THROW(BlurCodes(image, {.precision = SATPrecision::U32, .order = 2, .codes = {255, 255, false}},
                              SATWidths(glm::vec2(64))));
}

// The widest kernels over white, where every sum is as large as it can be: whole and not, square and flat. The next
// larger ones are refused.
TEST(ExactFilter, WhiteStaysWhiteUnderTheWidestKernels) {
    for (const SATPrecision precision : kExact) {
        for (uint32_t order = 2; order <= 3; order++) {
            // Codes so large that the widest kernels are small enough to try.
            const bool isWide = precision == SATPrecision::U64;
            const SATCodes codes{1, isWide ? 0x1p40 - 1 : 255, false};
            const auto largest = static_cast<int64_t>(codes.largest);
            const float mass = SATLargestMass(precision, codes);
            for (const bool isWhole : {true, false}) {
                for (const bool isFlat : {false, true}) {
                    const auto sizeOf = [&](float w) {
                        return isFlat ? glm::vec2(w, isWhole ? 1.0f : 1.5f) : glm::vec2(w);
                    };
                    const float step = isWhole && order == 2 ? 1 : 2;
                    float width = isWhole ? 1 : 1.5f;
                    while (width < 600 && SATBoxIsExact(sizeOf(width + step), static_cast<int>(order), isWhole, mass))
                        width += step;
                    const uint32_t side = order * static_cast<uint32_t>(width) + 9;
                    const uint32_t rows = isFlat ? 12 : side;
                    reference::CodeImage white{static_cast<int>(side), static_cast<int>(rows), {}};
                    white.texels.assign(size_t{side} * rows, {largest, largest, 0, largest});
                    const BlurDesc desc{.precision = precision, .order = order, .codes = codes};
                    for (const glm::vec4& texel : BlurCodes(white, desc, sizeOf(width)))
                        ASSERT_NEAR(texel.x / static_cast<float>(largest), 1, 2e-6)
                            << "order " << order << ", " << width << (isFlat ? " flat" : " square");
                    if (width < 600) {
                        EXPECT_THROW(BlurCodes(white, desc, sizeOf(width + step)), Error);
                    }
                }
            }
        }
    }
}

TEST(SATRange, TheLargestWholeWidthsOverEightBitWhiteAreThoseOfTheBound) {
    const SATCodes codes{255, 255, false};
    EXPECT_EQ(SATLargestWidthTexels(SATPrecision::U32, codes, 1), 4104u);
    EXPECT_EQ(SATLargestWidthTexels(SATPrecision::U64, codes, 2), 16400u);
    EXPECT_EQ(SATLargestWidthTexels(SATPrecision::U32, codes, 2), 64u);
    EXPECT_EQ(SATLargestWidthTexels(SATPrecision::U32, codes, 3), 15u);
    EXPECT_EQ(SATLargestWidthTexels(SATPrecision::U64, codes, 3), 645u);
    const SATCodes light{65535, 65535, false};
    EXPECT_EQ(SATLargestWidthTexels(SATPrecision::U32, light, 1), 256u);
}

// Whatever it calls exact fits, in exact arithmetic: the kernel's own sum over white, and the sums from its middle
// outwards of kernels that are not whole, which have a sign.
TEST(SATRange, IsNeverTrueWhereASumMayNotFit) {
    std::mt19937 random(49);
    size_t exact = 0;
    for (int i = 0; i < 400000; i++) {
        const bool isWhole = random() % 2 == 0;
        std::uniform_real_distribution<float> exponent(0, 14);
        glm::vec2 size(std::exp2(exponent(random)), std::exp2(exponent(random)));
        if (isWhole) size = 2.0f * glm::floor(size / 2.0f) + 1.0f;
        const uint32_t order = 1 + static_cast<uint32_t>(random() % 3);
        const double largest = std::floor(std::exp2(std::uniform_real_distribution<double>(0, 40)(random)));
        // long double has 64 digits: no sum that fits is rounded by more than 1 in 2^64.
        const auto axis = [&](double width) -> long double {
            const long double w = std::ceil(width);
            if (isWhole || order == 1) return std::pow(w, static_cast<long double>(order));
            // From the middle (of a tent) or the knot left of it (parabolic) to the farthest entry of the last knot.
            const long double d = order == 2 ? w + 2 : 2 * w + 3;
            return order == 2 ? d * (d + 1) / 2 : d * (d + 1) * (d + 2) / 6;
        };
        const long double sum = axis(size.x) * axis(size.y) * largest * (isWhole || order == 1 ? 1 : 2);
        for (const SATPrecision precision : kExact) {
            const SATCodes codes{1, largest, false};
            if (!SATBoxIsExact(size, static_cast<int>(order), isWhole, SATLargestMass(precision, codes))) continue;
            exact++;
            ASSERT_LT(sum, std::exp2(32.0L * WordsOf(precision)))
                << size.x << " x " << size.y << ", order " << order << ", codes to " << largest;
        }
    }
    EXPECT_GT(exact, 50000u);
}

TEST(SATGaussian, ErrorsAndWidthsAreThoseOfTheBestKernels) {
    for (const float error : {0.53f, 0.098f, 0.042f}) {
        const SATGaussian gaussian = SATGaussianWithin(error);
        const auto distance = [&](double width) {
            return reference::RelativeL2ToGaussian(static_cast<int>(gaussian.order), width);
        };
        EXPECT_LE(distance(gaussian.widthOverSigma), gaussian.relativeError);
        EXPECT_GT(distance(gaussian.widthOverSigma), gaussian.relativeError - 0.002);
        EXPECT_GT(distance(gaussian.widthOverSigma * 1.01), distance(gaussian.widthOverSigma));
        EXPECT_GT(distance(gaussian.widthOverSigma * 0.99), distance(gaussian.widthOverSigma));
    }
    EXPECT_ERROR(SATGaussianWithin(0.03f),
                 "a Gaussian within 3 %: the nearest kernel, the parabolic one, is within 4.2 %");
}

// On the device: the picture of one bright texel, against the Gaussian integrated over texels.
TEST(SATGaussian, AnImpulseComesOutAsAGaussianOfUnitSumWithinTheError) {
    constexpr int kSide = 121;
    constexpr double kSigma = 8;
    reference::CodeImage impulse{kSide, kSide, {}};
    impulse.texels.assign(kSide * kSide, {0, 0, 0, 0});
    impulse.texels[60 * kSide + 60] = {65535, 0, 0, 0};
    for (const double allowed : {0.10, 0.045}) {
        const SATGaussian gaussian = SATGaussianWithin(static_cast<float>(allowed));
        const Texels blurred = BlurCodes(
            impulse, {.precision = SATPrecision::U64, .order = gaussian.order, .codes = {65535, 65535, false}},
            SATWidths(glm::vec2(gaussian.widthOverSigma * static_cast<float>(kSigma))));
        double sum = 0, distance = 0, norm = 0;
        for (int y = 0; y < kSide; y++)
            for (int x = 0; x < kSide; x++) {
                const auto axis = [&](int at) {
                    const double edge = (at - 60 - 0.5) / (kSigma * std::sqrt(2.0));
                    return 0.5 * (std::erf(edge + 1 / (kSigma * std::sqrt(2.0))) - std::erf(edge));
                };
                const double expected = axis(x) * axis(y), actual = blurred[static_cast<size_t>(y * kSide + x)].x;
                sum += actual;
                distance += (actual - expected) * (actual - expected);
                norm += expected * expected;
            }
        EXPECT_NEAR(sum, 1, 1e-5);
        EXPECT_LE(std::sqrt(distance / norm), allowed) << "order " << gaussian.order;
    }
}

}  // namespace
}  // namespace boxcar
