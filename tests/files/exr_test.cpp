#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfPixelType.h>

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
              "its channels are G R; R G B [A], Y [A] or a single one are expected");
    EXPECT_EQ(ErrorFor(MakeExr({kSize, {{"l.R", f, v}, {"l.G", f, v}, {"l.B", f, v}}})),
              "its channels are l.B l.G l.R; R G B [A], Y [A] or a single one are expected");
}

TEST(ExrTest, LuminanceAndChromaIsRefused) {
    const Size even = {12, 18};
    const std::vector<float> v(12 * 18, 0.5f), quarter(6 * 9, 0.5f);
    const int h = Imf::HALF;
    EXPECT_EQ(ErrorFor(MakeExr({even, {{"Y", h, v}, {"RY", h, quarter, 2}, {"BY", h, quarter, 2}}})),
              "its channels are BY RY Y; R G B [A], Y [A] or a single one are expected");
    EXPECT_EQ(ErrorFor(MakeExr({even, {{"R", h, v}, {"G", h, v}, {"B", h, quarter, 2}}})),
              "its channel B is subsampled; one sample a texel is expected");
}

TEST(ExrTest, PartsAndDeepPixelsAreRefused) {
    constexpr char kMessage[] = "an EXR of several parts or of deep pixels; a single flat part is expected";
    const TemporaryFolder folder;
    std::vector<Imf::Header> headers(2, Imf::Header(2, 2));
    headers[0].setName("left");
    headers[1].setName("right");
    for (Imf::Header& header : headers) {
        header.setType(Imf::SCANLINEIMAGE);
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    }
    { const Imf::MultiPartOutputFile file(folder.Path("parts").c_str(), headers.data(), 2); }
    EXPECT_EQ(ErrorFor(Contents(folder.Path("parts"))), kMessage);

    Imf::Header deep(2, 2);
    deep.setType(Imf::DEEPSCANLINE);
    deep.compression() = Imf::ZIPS_COMPRESSION;
    deep.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    { const Imf::DeepScanLineOutputFile file(folder.Path("deep").c_str(), deep); }
    EXPECT_EQ(ErrorFor(Contents(folder.Path("deep"))), kMessage);
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
