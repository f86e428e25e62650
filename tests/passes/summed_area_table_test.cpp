// Building the table on the device against sums in double.
#include "runtime/passes/summed_area_table.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtents[] = {{1, 1},  {1, 6},     {6, 1},     {12, 19},   {49, 2},
                                 {16, 4}, {100, 300}, {256, 256}, {1000, 667}};
constexpr uint32_t kTaps[] = {2, 4, 8, 16};
constexpr TapAddressing kAddressings[] = {TapAddressing::Interpolated, TapAddressing::Integer};
constexpr double kUnit = 0x1p-24;

Texels TableOf(Extent2D extent, const Texels& source, uint32_t taps = 2,
               TapAddressing addressing = TapAddressing::Interpolated, glm::vec4 bias = glm::vec4(0),
               SATOrigin origin = SATOrigin::Corner) {
    SummedAreaTable table(TestDevice(), {.extent = extent, .taps = taps, .addressing = addressing, .origin = origin});
    const Image biasTexel = Upload({1, 1}, Texels(1, bias));
    return RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
        return *table.Record(commands, image, bias == glm::vec4(0) ? nullptr : &biasTexel).low;
    });
}

bool SameBits(const Texels& a, const Texels& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec4)) == 0;
}

// Additions between a texel and its table entry, one a level of the tree along x and then along y.
double TreeDepth(Extent2D extent) {
    return std::bit_width(extent.widthTexels - 1) + std::bit_width(extent.heightTexels - 1);
}

TEST(SummedAreaTable, ScheuermannsFourByFourExampleIsExact) {
    const float source[16] = {2, 3, 2, 1, 3, 0, 1, 2, 1, 3, 1, 0, 1, 4, 2, 2};
    const float expected[16] = {2, 5, 7, 8, 5, 8, 11, 14, 6, 12, 16, 19, 7, 17, 23, 28};
    const Texels texels(source, source + 16);
    for (const TapAddressing addressing : kAddressings) {
        for (const uint32_t taps : kTaps) {
            const Texels table = TableOf({4, 4}, texels, taps, addressing);
            for (size_t i = 0; i < 16; i++)
                EXPECT_EQ(table[i], glm::vec4(expected[i])) << "entry " << i;
        }
    }
}

TEST(SummedAreaTable, GreensFourByFourExampleIsExact) {
    const Texels table = TableOf({4, 4}, Texels(16, glm::vec4(1)));
    for (int y = 0; y < 4; y++)
        for (int x = 0; x < 4; x++)
            EXPECT_EQ(table[4 * y + x].x, static_cast<float>((x + 1) * (y + 1))) << x << ", " << y;
}

// Whole codes up to 256 x 256 texels sum to less than 2^24: float32 has to be exact.
TEST(SummedAreaTable, WholeCodesSumExactlyAtEverySizeUpTo256) {
    for (const Extent2D extent : kExtents) {
        if (extent.Texels() > 256 * 256) continue;
        const Texels source = RandomCodes(extent, 1);
        const auto expected = reference::SummedAreaTable(ToDouble(extent, source));
        for (const TapAddressing addressing : kAddressings) {
            for (const uint32_t taps : kTaps) {
                const Texels table = TableOf(extent, source, taps, addressing);
                size_t wrong = 0;
                for (size_t i = 0; i < table.size(); i++)
                    wrong += glm::dvec4(table[i]) != expected.texels[i];
                EXPECT_EQ(wrong, 0u) << extent.widthTexels << " x " << extent.heightTexels << ", " << taps << " taps";
            }
        }
    }
}

// A sum by a tree of depth d is off by at most d u times the sum of magnitudes.
TEST(SummedAreaTable, EntriesAreWithinTheTreesErrorBound) {
    for (const Extent2D extent : kExtents) {
        const Texels source = RandomValues(extent, 2);
        const auto expected = reference::SummedAreaTable(ToDouble(extent, source));
        const Texels table = TableOf(extent, source, 4);
        const double relative = TreeDepth(extent) * kUnit;
        for (size_t i = 0; i < table.size(); i++)
            for (int c = 0; c < 4; c++)
                ASSERT_NEAR(table[i][c], expected.texels[i][c], relative * expected.texels[i][c])
                    << extent.widthTexels << " x " << extent.heightTexels << ", entry " << i;
    }
}

TEST(SummedAreaTable, EveryTapsGivesTheSameBits) {
    for (const Extent2D extent : kExtents) {
        const Texels source = RandomValues(extent, 3);
        const Texels twoTaps = TableOf(extent, source, 2);
        for (const TapAddressing addressing : kAddressings)
            for (const uint32_t taps : kTaps)
                EXPECT_TRUE(SameBits(TableOf(extent, source, taps, addressing), twoTaps))
                    << extent.widthTexels << " x " << extent.heightTexels << ", " << taps << " taps";
    }
}

TEST(SummedAreaTable, PassCountIsTheSmallestThatReachesTheFarEnd) {
    EXPECT_EQ(SummedAreaTablePassCount(1, 2), 0u);
    EXPECT_EQ(SummedAreaTablePassCount(2, 2), 1u);
    EXPECT_EQ(SummedAreaTablePassCount(256, 16), 2u);
    EXPECT_EQ(SummedAreaTablePassCount(257, 16), 3u);
    EXPECT_EQ(SummedAreaTablePassCount(512, 16), 3u);
    EXPECT_EQ(SummedAreaTablePassCount(1000, 2), 10u);
    EXPECT_EQ(SummedAreaTablePassCount(16384, 2), 14u);
    EXPECT_EQ(SummedAreaTablePassCount(4294967295u, 16), 8u);
}

// Scheuermann 2005: 512 texels with 16 taps take six passes, of which two add only two texels.
TEST(SummedAreaTable, TheLastPassOfAnAxisAddsOnlyWhatIsLeft) {
    const SummedAreaTable table(TestDevice(), {.extent = {512, 512}, .taps = 16});
    std::vector<uint32_t> taps;
    for (uint32_t pass = 0; pass < table.Passes(); pass++)
        taps.push_back(table.TapsOf(pass));
    EXPECT_EQ(taps, std::vector<uint32_t>({16, 16, 2, 16, 16, 2}));
    EXPECT_EQ(SummedAreaTable(TestDevice(), {.extent = {513, 1}, .taps = 16}).TapsOf(2), 4u);
}

// Hensley 2005, Fig. 3: after the first pass with two taps each texel holds its own value and its left neighbour's.
TEST(SummedAreaTable, FirstPassAddsTheNeighbourToTheLeft) {
    const Extent2D extent{4, 1};
    SummedAreaTable table(TestDevice(), {.extent = extent, .taps = 2});
    const Texels source = {glm::vec4(1), glm::vec4(10), glm::vec4(100), glm::vec4(1000)};
    const Texels after = RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
        return *table.RecordFirst(commands, image, 1).low;
    });
    EXPECT_EQ(after, Texels({glm::vec4(1), glm::vec4(11), glm::vec4(110), glm::vec4(1100)}));
}

// Erratum: the paper's loop over r reads lists r + 1 terms.
TEST(SummedAreaTable, APassAddsAsManyTexelsAsItHasTaps) {
    const Extent2D extent{64, 1};
    for (const uint32_t taps : kTaps) {
        SummedAreaTable table(TestDevice(), {.extent = extent, .taps = taps});
        const Texels after = RunOnDevice(extent, Texels(64, glm::vec4(1)),
                                         [&](CommandList& commands, const Image& image) -> const Image& {
                                             return *table.RecordFirst(commands, image, 1).low;
                                         });
        EXPECT_EQ(after[63], glm::vec4(static_cast<float>(taps)));
    }
}

// Erratum: the pseudo-code adds x + 2^i; sums run from the left and the top, so it is x - 2^i.
TEST(SummedAreaTable, ATexelCountsToItsRightAndBelowOnly) {
    const Extent2D extent{5, 5};
    Texels source(25, glm::vec4(0));
    source[2 * 5 + 1] = glm::vec4(7);
    const Texels table = TableOf(extent, source);
    for (int y = 0; y < 5; y++)
        for (int x = 0; x < 5; x++)
            EXPECT_EQ(table[5 * y + x].x, x >= 1 && y >= 2 ? 7.0f : 0.0f) << x << ", " << y;
}

// Erratum: leaving out 2^i texels in pass i leaves stale ones in one of the two targets. Here both targets are full
// of another picture's sums, so every texel that is left out too early shows.
TEST(SummedAreaTable, NothingOfAnEarlierPictureIsLeftInTheTable) {
    for (const Extent2D extent :
         {Extent2D{64, 64}, Extent2D{2, 37}, Extent2D{37, 2}, Extent2D{1, 17}, Extent2D{300, 5}}) {
        for (const uint32_t taps : kTaps) {
            SummedAreaTable table(TestDevice(), {.extent = extent, .taps = taps});
            const auto record = [&](CommandList& commands, const Image& image) -> const Image& {
                return *table.Record(commands, image).low;
            };
            for (int i = 0; i < 2; i++)
                RunOnDevice(extent, Texels(extent.Texels(), glm::vec4(1000)), record);
            const Texels source = RandomCodes(extent, 4);
            const auto expected = reference::SummedAreaTable(ToDouble(extent, source));
            const Texels result = RunOnDevice(extent, source, record);
            for (size_t i = 0; i < result.size(); i++)
                ASSERT_EQ(glm::dvec4(result[i]), expected.texels[i])
                    << extent.widthTexels << " x " << extent.heightTexels << ", " << taps << " taps, entry " << i;
        }
    }
}

TEST(SummedAreaTable, LeavesItsSourceAlone) {
    const Extent2D extent{20, 10};
    const Texels source = RandomValues(extent, 5);
    const Image image = Upload(extent, source);
    SummedAreaTable table(TestDevice(), {.extent = extent});
    const Image bias = Upload({1, 1}, Texels(1, glm::vec4(0.5f)));
    CommandList commands(TestDevice());
    table.Record(commands, image, &bias);
    commands.SubmitAndWait();
    EXPECT_TRUE(SameBits(Download(image), source));
}

TEST(SummedAreaTable, BiasIsTakenOffTexelsAndNotOffTheOutside) {
    const Extent2D extent{37, 21};
    const glm::vec4 bias(0.5f, 1, 0, 128);
    Texels source = RandomCodes(extent, 6);
    const Texels table = TableOf(extent, source, 4, TapAddressing::Interpolated, bias);
    for (glm::vec4& texel : source)
        texel -= bias;
    const auto expected = reference::SummedAreaTable(ToDouble(extent, source));
    for (size_t i = 0; i < table.size(); i++)
        ASSERT_EQ(glm::dvec4(table[i]), expected.texels[i]) << "entry " << i;
}

// Erratum: with the mean taken off, the last entry is 0 only up to rounding.
TEST(SummedAreaTable, LastEntryLessTheMeanIsZeroUpToRounding) {
    const Extent2D extent{100, 300};
    const Texels source = RandomValues(extent, 7);
    glm::dvec4 mean(0);
    for (const glm::vec4& texel : source)
        mean += glm::dvec4(texel) / static_cast<double>(source.size());
    const glm::vec4 bias(mean);
    const Texels table = TableOf(extent, source, 4, TapAddressing::Interpolated, bias);

    double magnitudes = 0;
    for (const glm::vec4& texel : source)
        magnitudes += std::abs(texel.x - bias.x);
    // Every difference is rounded, every sum is, and the mean itself was.
    const double bound =
        (TreeDepth(extent) + 1) * kUnit * magnitudes + kUnit * mean.x * static_cast<double>(source.size());
    EXPECT_LE(std::abs(table.back().x), bound);
    EXPECT_GT(TableOf(extent, source).back().x, 10000) << "without a bias it is the sum of 30,000 texels";
}

// F about the origin, from the definition: the sum between the origin's corner and the texel, both sides included.
reference::DoubleImage TableAbout(const reference::DoubleImage& image, glm::ivec2 origin) {
    reference::DoubleImage table = image;
    const auto add = [&](int x, int y, int fromX, int fromY) {
        table.texels[static_cast<size_t>(y) * image.width + x] += table.At(fromX, fromY);
    };
    for (int y = 0; y < image.height; y++) {
        for (int x = origin.x + 1; x < image.width; x++)
            add(x, y, x - 1, y);
        for (int x = origin.x - 2; x >= 0; x--)
            add(x, y, x + 1, y);
    }
    for (int x = 0; x < image.width; x++) {
        for (int y = origin.y + 1; y < image.height; y++)
            add(x, y, x, y - 1);
        for (int y = origin.y - 2; y >= 0; y--)
            add(x, y, x, y + 1);
    }
    return table;
}

TEST(SummedAreaTable, SumsFromTheMiddleAndFromTheLowerLeftAreExactOnWholeCodes) {
    for (const Extent2D extent : kExtents) {
        if (extent.Texels() > 256 * 256) continue;
        const Texels source = RandomCodes(extent, 8);
        for (const SATOrigin origin : {SATOrigin::Center, SATOrigin::LowerLeft}) {
            const auto expected = TableAbout(ToDouble(extent, source), OriginTexels(origin, extent));
            for (const uint32_t taps : kTaps) {
                const Texels table = TableOf(extent, source, taps, TapAddressing::Integer, glm::vec4(0), origin);
                size_t wrong = 0;
                for (size_t i = 0; i < table.size(); i++)
                    wrong += glm::dvec4(table[i]) != expected.texels[i];
                EXPECT_EQ(wrong, 0u) << extent.widthTexels << " x " << extent.heightTexels << ", " << taps << " taps";
            }
        }
    }
}

TEST(SummedAreaTable, SumsFromTheMiddleTakeOnePassLessWithTwoTaps) {
    EXPECT_EQ(SummedAreaTable(TestDevice(), {.extent = {512, 512}, .taps = 2}).Passes(), 18u);
    EXPECT_EQ(SummedAreaTable(TestDevice(), {.extent = {512, 512}, .taps = 2, .origin = SATOrigin::Center}).Passes(),
              16u);
}

// Erratum: 40 bits for the second order, where the paper's text has 44.
TEST(SummedAreaTable, BitsAreThoseOfThePapersFormula) {
    EXPECT_EQ(SummedAreaTableBits({256, 256}, 8), 24);
    EXPECT_EQ(SummedAreaTableBits({256, 256}, 8, 2), 40);
    EXPECT_EQ(SummedAreaTableBits({1024, 512}, 16, 3), 73);
}

TEST(SummedAreaTable, RefusesAnOrderOfFloats) {
    EXPECT_ERROR(SummedAreaTable(TestDevice(), {.extent = {4, 4}, .order = 2}),
                 "order 2 in floats: they have too few digits for it; U32 and U64 hold it exactly");
}

// What the header documents, and what a device really holds.
TEST(SummedAreaTable, TakesTheDocumentedMemory) {
    const Extent2D extent{512, 256};
    for (const SATPrecision precision : {SATPrecision::FP32, SATPrecision::U32, SATPrecision::U64}) {
        const uint64_t before = TestDevice().MemoryBytes();
        const SummedAreaTable table(TestDevice(), {.extent = extent, .precision = precision});
        EXPECT_EQ(SummedAreaTableBytes(extent, precision),
                  extent.Texels() * (precision == SATPrecision::U64 ? 64 : 32));
        EXPECT_EQ(TestDevice().MemoryBytes() - before, SummedAreaTableBytes(extent, precision));
    }
}

TEST(SummedAreaTable, RefusesTapsThatNoPassHas) {
    try {
        SummedAreaTable(TestDevice(), {.extent = {4, 4}, .taps = 3});
        FAIL() << "3 taps were taken";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "3 taps: a pass adds 2, 4, 8 or 16 texels");
    }
}

TEST(SummedAreaTable, RefusesAnEmptyImage) {
    EXPECT_THROW(SummedAreaTable(TestDevice(), {.extent = {0, 4}}), Error);
}

}  // namespace
}  // namespace boxcar
