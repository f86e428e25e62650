#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfPixelType.h>

#include <optional>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

constexpr Size kSize = {12, 19};
constexpr size_t kTexels = 12 * 19;

Picture Read(const Bytes& bytes) {
    const TemporaryFolder folder;
    return ReadPicture(folder.Put("p.exr", bytes));
}

std::string ErrorFor(const Bytes& bytes) {
    const TemporaryFolder folder;
    const std::string path = folder.Put("p.exr", bytes);
    const std::string error = ErrorOf([&] { ReadPicture(path); });
    EXPECT_TRUE(error.starts_with(path + ": ")) << error;
    return error.substr(std::min(error.size(), path.size() + 2));
}

// One channel of slow ramps that halves hold exactly.
std::vector<float> Ramp(float scale) {
    std::vector<float> values;
    for (uint32_t y = 0; y < kSize.height; ++y)
        for (uint32_t x = 0; x < kSize.width; ++x)
            values.push_back(scale * static_cast<float>(2 * x + 3 * y) / 128.0f);
    return values;
}

Picture Interleave(const std::vector<std::vector<float>>& channels) {
    Picture picture{kSize.width, kSize.height, static_cast<uint32_t>(channels.size()), SampleType::Float32, {}};
    for (size_t i = 0; i < kTexels; ++i)
        for (const auto& channel : channels)
            picture.samples.push_back(channel[i]);
    return picture;
}

struct Kind {
    int compression;
    bool tiled;
    int type;
    float tolerance;

    friend std::ostream& operator<<(std::ostream& to, const Kind& kind) {
        constexpr const char* kNames[] = {"None",  "Rle", "Zips", "Zip",  "Piz",
                                          "Pxr24", "B44", "B44a", "Dwaa", "Dwab"};
        return to << kNames[kind.compression] << (kind.tiled ? "Tiles" : "Lines")
                  << (kind.type == Imf::HALF ? "Half" : "Float");
    }
};

class ExrKindTest : public testing::TestWithParam<Kind> {};

TEST_P(ExrKindTest, IsReadWithinWhatTheCompressionLoses) {
    const Kind& kind = GetParam();
    const std::vector<float> r = Ramp(1.0f), g = Ramp(0.5f), b = Ramp(0.25f), a = Ramp(0.125f);
    const ExrFile file{kSize,
                       {{"R", kind.type, r}, {"G", kind.type, g}, {"B", kind.type, b}, {"A", kind.type, a}},
                       kind.compression,
                       -7,
                       100,
                       kind.tiled};
    const Picture read = Read(MakeExr(file));
    const Picture expected = Interleave({r, g, b, a});
    EXPECT_EQ(read.widthTexels, kSize.width);
    EXPECT_EQ(read.heightTexels, kSize.height);
    EXPECT_EQ(read.channels, 4u);
    EXPECT_EQ(read.stored, SampleType::Float32);
    ASSERT_EQ(read.samples.size(), expected.samples.size());
    for (size_t i = 0; i < read.samples.size(); ++i)
        ASSERT_NEAR(read.samples[i], expected.samples[i], kind.tolerance) << "sample " << i;
}

std::vector<Kind> Kinds() {
    std::vector<Kind> kinds;
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression) {
        const bool lossy = compression >= Imf::B44_COMPRESSION && compression <= Imf::DWAB_COMPRESSION;
        for (const bool tiled : {false, true})
            for (const int type : {Imf::HALF, Imf::FLOAT})
                kinds.push_back({compression, tiled, type, lossy ? 0.02f : 0.0f});
    }
    return kinds;
}

INSTANTIATE_TEST_SUITE_P(Kinds, ExrKindTest, testing::ValuesIn(Kinds()), testing::PrintToStringParamName());

TEST(ExrTest, HalvesAndUintsBecomeTheFloatsTheyAre) {
    std::vector<float> halves;
    for (uint32_t i = 0; i < kTexels; ++i) {
        half value;
        value.setBits(static_cast<uint16_t>(i * 271 & 0xbfff));  // of both signs, denormal ones too; all finite
        halves.push_back(value);
    }
    ExpectSame(Read(MakeExr({kSize, {{"Y", Imf::HALF, halves}}})), Interleave({halves}));

    std::vector<float> integers;
    for (uint32_t i = 0; i < kTexels; ++i)
        integers.push_back(static_cast<float>(i * 65536));
    ExpectSame(Read(MakeExr({kSize, {{"Y", Imf::UINT, integers}}})), Interleave({integers}));
}

TEST(ExrTest, ChannelsAreChosenByName) {
    const std::vector<float> r = Ramp(1), g = Ramp(2), b = Ramp(3), a = Ramp(4), z = Ramp(5);
    const auto read = [](std::vector<ExrFile::Channel> channels) {
        return Read(MakeExr({kSize, std::move(channels)}));
    };
    const int f = Imf::FLOAT;
    ExpectSame(read({{"R", f, r}, {"G", f, g}, {"B", f, b}}), Interleave({r, g, b}));
    ExpectSame(read({{"R", f, r}, {"G", f, g}, {"B", f, b}, {"Z", f, z}, {"left.R", f, z}}), Interleave({r, g, b}));
    ExpectSame(read({{"Y", f, r}, {"A", f, a}}), Interleave({r, a}));
    ExpectSame(read({{"Z", f, z}}), Interleave({z}));
    ExpectSame(read({{"depth.V", f, z}}), Interleave({z}));
}

TEST(ExrTest, OtherChannelsAreRefusedByName) {
    const std::vector<float> v = Ramp(1);
    const int f = Imf::FLOAT;
    EXPECT_EQ(ErrorFor(MakeExr({kSize, {{"R", f, v}, {"G", f, v}}})),
              "its channels are G R; R G B [A], Y [A], Y RY BY [A] or a single one are expected");
    EXPECT_EQ(ErrorFor(MakeExr({kSize, {{"l.R", f, v}, {"l.G", f, v}, {"l.B", f, v}}})),
              "its channels are l.B l.G l.R; R G B [A], Y [A], Y RY BY [A] or a single one are expected");
}

// Written by the library from colors that change slowly, so that little is lost with three quarters of the chroma.
TEST(ExrTest, LuminanceAndChromaBecomeRgb) {
    constexpr Size kLarge = {48, 40};
    const auto colorAt = [](uint32_t x, uint32_t y) {
        return std::array{0.5f + 0.01f * static_cast<float>(x), 0.6f, 0.9f - 0.01f * static_cast<float>(y),
                          static_cast<float>(x % 2)};
    };
    for (const uint32_t channels : {3u, 4u}) {
        const Picture picture = Read(MakeChromaExr(kLarge, channels, colorAt));
        EXPECT_EQ(picture.widthTexels, kLarge.width);
        EXPECT_EQ(picture.heightTexels, kLarge.height);
        ASSERT_EQ(picture.channels, channels);
        EXPECT_TRUE(picture.notes.empty());
        const float* sample = picture.samples.data();
        for (uint32_t y = 0; y < kLarge.height; ++y)
            for (uint32_t x = 0; x < kLarge.width; ++x)
                for (uint32_t c = 0; c < channels; ++c)
                    ASSERT_NEAR(*sample++, colorAt(x, y)[c], 0.02) << x << ", " << y << ", channel " << c;
    }
}

TEST(ExrTest, SubsampledColorIsRefused) {
    const Size even = {12, 18};
    const std::vector<float> v(12 * 18, 0.5f), quarter(6 * 9, 0.5f);
    const int h = Imf::HALF;
    EXPECT_EQ(ErrorFor(MakeExr({even, {{"R", h, v}, {"G", h, v}, {"B", h, quarter, 2}}})),
              "its channel B is subsampled; one sample a texel is expected");
    EXPECT_EQ(ErrorFor(MakeExr({even, {{"Y", h, v}, {"RY", h, quarter, 2}}})),
              "its channels are RY Y; R G B [A], Y [A], Y RY BY [A] or a single one are expected");
}

// The window and its data, as if they were drawn on an endless black plane.
TEST(ExrTest, ThePictureIsTheDisplayWindow) {
    const std::vector<float> r = Ramp(1), g = Ramp(2), b = Ramp(3), a = Ramp(4);
    const int f = Imf::FLOAT;
    constexpr int kMinX = 5, kMinY = -3;
    const std::array<int, 4> displays[] = {{0, -9, 30, 30},  {5, -3, 16, 15}, {7, 0, 9, 9},    {0, 0, 9, 40},
                                           {10, -9, 40, -1}, {5, -20, 16, 0}, {16, 15, 45, 41}};
    for (const auto& display : displays) {
        for (const bool tiled : {false, true}) {
            SCOPED_TRACE(fmt::format("({}, {}) to ({}, {})", display[0], display[1], display[2], display[3]));
            const Picture picture = Read(MakeExr({kSize,
                                                  {{"R", f, r}, {"G", f, g}, {"B", f, b}, {"A", f, a}},
                                                  Imf::ZIP_COMPRESSION,
                                                  kMinX,
                                                  kMinY,
                                                  tiled,
                                                  display}));
            ASSERT_EQ(picture.widthTexels, static_cast<uint32_t>(display[2] - display[0] + 1));
            ASSERT_EQ(picture.heightTexels, static_cast<uint32_t>(display[3] - display[1] + 1));
            const float* sample = picture.samples.data();
            for (int y = display[1]; y <= display[3]; ++y)
                for (int x = display[0]; x <= display[2]; ++x) {
                    const int column = x - kMinX, row = y - kMinY;
                    const bool isInside = column >= 0 && column < 12 && row >= 0 && row < 19;
                    const auto i = static_cast<size_t>(row * 12 + column);
                    for (const auto* channel : {&r, &g, &b, &a})
                        ASSERT_EQ(*sample++, isInside ? (*channel)[i] : 0.0f) << x << ", " << y;
                }
            const bool isWhole = display[0] <= 5 && display[1] <= -3 && display[2] >= 16 && display[3] >= 15;
            EXPECT_EQ(picture.notes.size(), isWhole ? 0u : 1u);
        }
    }
    EXPECT_EQ(
        Read(MakeExr({kSize, {{"Y", f, r}}, Imf::ZIP_COMPRESSION, kMinX, kMinY, false, {0, 0, 9, 40}})).notes,
        std::vector<std::string>{"its texels outside the display window are left out: data (5, -3) to (16, 15), "
                                 "display (0, 0) to (9, 40)"});
}

// Without the name of the file.
std::string FaultOf(const Bytes& bytes) {
    const std::string line = ErrorOf([&] { Read(bytes); });
    return line.substr(line.find(": ") + 2);
}

TEST(ExrTest, TexelsAllOutsideTheDisplayWindowAreRefused) {
    const std::array<int, 4> displays[] = {{40, 40, 45, 41}, {0, 0, 4, 60}, {17, 0, 20, 3}, {5, 16, 9, 20}};
    for (const auto& d : displays)
        EXPECT_EQ(
            FaultOf(MakeExr({kSize, {{"Y", Imf::FLOAT, Ramp(1)}}, Imf::ZIP_COMPRESSION, 5, -3, false, d})),
            fmt::format("its texels, (5, -3) to (16, 15), are all outside its display window, ({}, {}) to ({}, {}); "
                        "some are expected within",
                        d[0], d[1], d[2], d[3]));
}

TEST(ExrTest, AFileThatEndsInItsTexelsIsCutOff) {
    const Bytes whole = MakeExr({kSize, {{"Y", Imf::FLOAT, Ramp(1)}}, Imf::NO_COMPRESSION});
    for (const size_t missing : {size_t{1}, size_t{100}, whole.size() / 2})
        EXPECT_EQ(FaultOf(Bytes(whole.begin(), whole.end() - static_cast<ptrdiff_t>(missing))),
                  "cut off: the EXR ends before its picture does");
}

TEST(ExrTest, ChromaticitiesAreReadAndWritten) {
    const TemporaryFolder folder;
    // ACES AP0: SMPTE ST 2065-1
    const Primaries aces = {0.7347f, 0.2653f, 0, 1, 0.0001f, -0.077f, 0.32168f, 0.33767f};
    Picture picture = PatternPicture(kSize, 3, SampleType::Float32);
    picture.colorSpace.primaries = aces;
    WritePicture(picture, folder.Path("p.exr"), FileFormat::Exr, SampleType::Float32);
    const Picture read = ReadPicture(folder.Path("p.exr"));
    EXPECT_EQ(read.colorSpace.primaries, aces);
    EXPECT_TRUE(read.notes.empty());

    picture.colorSpace.primaries = {0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f};
    WritePicture(picture, folder.Path("p.exr"), FileFormat::Exr, SampleType::Float32);
    EXPECT_EQ(ReadPicture(folder.Path("p.exr")).colorSpace.primaries, std::nullopt);  // sRGB's
}

TEST(ExrTest, OfSeveralPartsTheFirstWithAPictureIsRead) {
    const Picture color = Read(MakePartsExr({{"depth", "Z"}, {"left", "RGB"}, {"right", "RGBA"}}));
    ExpectSame(color, {2, 2, 3, SampleType::Float32, std::vector<float>(12, 2.0f)});
    EXPECT_EQ(color.notes, std::vector<std::string>{"part left is read and the others are not: depth, right"});

    const Picture depth = Read(MakePartsExr({{"ids", "UV"}, {"depth", "Z"}}));
    ExpectSame(depth, {2, 2, 1, SampleType::Float32, std::vector<float>(4, 2.0f)});
    EXPECT_EQ(depth.notes, std::vector<std::string>{"part depth is read and the others are not: ids"});

    EXPECT_EQ(ErrorFor(MakePartsExr({{"a", "UV"}, {"b", "NM"}})),
              "its channels are U V M N; R G B [A], Y [A], Y RY BY [A] or a single one are expected");
}

TEST(ExrTest, DeepPixelsAreRefused) {
    const TemporaryFolder folder;
    Imf::Header deep(2, 2);
    deep.setType(Imf::DEEPSCANLINE);
    deep.compression() = Imf::ZIPS_COMPRESSION;
    deep.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    { const Imf::DeepScanLineOutputFile file(folder.Path("deep").c_str(), deep); }
    EXPECT_EQ(ErrorFor(Contents(folder.Path("deep"))), "an EXR of deep pixels; flat ones are expected");
}

TEST(ExrTest, WritesFloatScanLinesPackedByZip) {
    const TemporaryFolder folder;
    WritePicture(PatternPicture(kSize, 2, SampleType::Float32), folder.Path("p.exr"), FileFormat::Exr,
                 SampleType::Float32);
    const Bytes file = Contents(folder.Path("p.exr"));
    const std::string text(file.begin(), file.end());
    using namespace std::string_literals;
    EXPECT_EQ(text.substr(0, 8), "\x76\x2f\x31\x01\x02\0\0\0"s);  // version 2, no flag: one part, flat, scan lines
    EXPECT_NE(text.find("compression\0compression\0\1\0\0\0\3"s), std::string::npos);
    EXPECT_NE(text.find("A\0\2\0\0\0"s), std::string::npos);  // a channel and its type, 2: float
    EXPECT_NE(text.find("Y\0\2\0\0\0"s), std::string::npos);
}

}  // namespace
}  // namespace boxcar::test
