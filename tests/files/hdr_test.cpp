#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

using Texel = std::array<uint8_t, 4>;

TEST(HdrTest, RgbeIsMantissaTimesAPowerOfTwo) {
    // Ward 1991: mantissa / 256 x 2^(exponent - 128); exponent 0 is black
    const TemporaryFolder folder;
    const std::vector<std::array<uint8_t, 4>> texels = {{128, 64, 32, 129}, {255, 1, 0, 128}, {200, 100, 50, 0}};
    const Picture picture = ReadPicture(folder.Put("p", MakeHdr({3, 1}, texels, false)));
    ExpectSame(picture,
               {3, 1, 3, SampleType::Float32, {1.0f, 0.5f, 0.25f, 255 / 256.0f, 1 / 256.0f, 0.0f, 0.0f, 0.0f, 0.0f}});
}

TEST(HdrTest, PackedAndFlatFilesAreTheSame) {
    const TemporaryFolder folder;
    for (const Size size : {Size{12, 19}, Size{49, 2}, Size{300, 3}}) {
        std::vector<std::array<uint8_t, 4>> texels;
        for (uint32_t i = 0; i < size.width * size.height; ++i)
            texels.push_back({static_cast<uint8_t>(128 + i % 100), static_cast<uint8_t>(i / 7), 9,
                              static_cast<uint8_t>(120 + i % 9)});
        const Picture packed = ReadPicture(folder.Put("packed", MakeHdr(size, texels, true)));
        ExpectSame(packed, ReadPicture(folder.Put("flat", MakeHdr(size, texels, false))));
        EXPECT_EQ(packed.widthTexels, size.width);
        EXPECT_EQ(packed.samples[3], 129.0f / 256 / 128);
    }
}

TEST(HdrTest, OtherLayoutsAreRefusedInOneLine) {
    const TemporaryFolder folder;
    const auto errorOf = [&](const std::string& text) {
        return ErrorOf([&] { ReadPicture(folder.Put("p", ToBytes(text))); });
    };
    const std::string path = folder.Path("p");
    EXPECT_EQ(errorOf("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234"),
              path + ": an HDR of XYZ colors (32-bit_rle_xyze); 32-bit_rle_rgbe is expected");
    EXPECT_EQ(errorOf("#?RADIANCE\nFORMAT=ascii\n\n-Y 1 +X 1\n1234"),
              path + ": an HDR of ascii; 32-bit_rle_rgbe is expected");
    for (const std::string sides : {"+X 1 -X 1", "-Y 1", "-Y 1 1", "-Y x +X 1", "1 1", "", "-Y -1 +X 1"})
        EXPECT_EQ(errorOf("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + sides + "\n1234"),
                  path + ": damaged HDR: \"" + sides +
                      "\" for its sides; -Y HEIGHT +X WIDTH is expected, or another order of the axes");
}

std::vector<Texel> SomeTexels(Size size) {
    std::vector<Texel> texels;
    for (uint32_t i = 0; i < size.width * size.height; ++i) {
        const auto x = static_cast<uint8_t>(i % size.width / 5);  // with runs
        texels.push_back({static_cast<uint8_t>(128 + i / size.width), x, 9, static_cast<uint8_t>(120 + x % 9)});
    }
    return texels;
}

// Ward's first run-length coding: mantissas of 1 1 1 repeat the texel before, so many times as their exponent says;
// more of them one after another are the bytes of the count, lowest first.
Bytes OldRuns(std::span<const Texel> row) {
    Bytes bytes;
    for (size_t x = 0; x < row.size();) {
        size_t end = x + 1;
        while (end < row.size() && row[end] == row[x])
            ++end;
        bytes.insert(bytes.end(), row[x].begin(), row[x].end());
        for (size_t count = end - x - 1; count > 0; count >>= 8)
            bytes.insert(bytes.end(), {1, 1, 1, static_cast<uint8_t>(count & 255)});
        x = end;
    }
    return bytes;
}

TEST(HdrTest, EveryRowHasItsOwnCoding) {
    const TemporaryFolder folder;
    constexpr Size kSize = {600, 9};
    const std::vector<Texel> texels = SomeTexels(kSize);
    const Picture expected = ReadPicture(folder.Put("flat", MakeHdr(kSize, texels, false)));
    Bytes file = MakeHdr({kSize.width, 0}, {}, false);
    const std::string sides = "-Y 0";
    *(std::search(file.begin(), file.end(), sides.begin(), sides.end()) + 3) = '9';
    for (size_t y = 0; y < kSize.height; ++y) {
        const std::span row = std::span(texels).subspan(y * kSize.width, kSize.width);
        const Size rowSize = {kSize.width, 1};
        const Bytes whole = MakeHdr(rowSize, {row.begin(), row.end()}, y % 3 == 0);
        const size_t headerBytes = MakeHdr({kSize.width, 0}, {}, false).size();
        const Bytes bytes =
            y % 3 == 2 ? OldRuns(row) : Bytes(whole.begin() + static_cast<ptrdiff_t>(headerBytes), whole.end());
        file.insert(file.end(), bytes.begin(), bytes.end());
    }
    ExpectSame(ReadPicture(folder.Put("mixed", file)), expected);
}

TEST(HdrTest, LongRunsOfTheFirstCodingHaveSeveralCounts) {
    const TemporaryFolder folder;
    const std::vector<Texel> texels(70'000 / 10, Texel{200, 100, 50, 129});
    Bytes file = ToBytes("#?RGBE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 7000\n");  // CR LF in the header too
    const Bytes row = OldRuns(texels);
    EXPECT_EQ(row.size(), 12u);
    file.insert(file.end(), row.begin(), row.end());
    ExpectSame(ReadPicture(folder.Put("old", file)),
               ReadPicture(folder.Put("flat", MakeHdr({7000, 1}, texels, false))));
}

TEST(HdrTest, RunsBeyondTheirRowAreRefused) {
    const TemporaryFolder folder;
    const auto errorOf = [&](const std::string& row) {
        const std::string path = folder.Put("p", ToBytes("#?RADIANCE\n\n-Y 1 +X 8\n" + row + std::string(64, 'x')));
        return ErrorOf([&] { ReadPicture(path); }).substr(path.size() + 2);
    };
    using namespace std::string_literals;
    EXPECT_EQ(errorOf("\2\2\0\x9"s), "damaged HDR: a row of 9 texels in a picture of 8");
    EXPECT_EQ(errorOf("\2\2\0\x8\x89"s), "damaged HDR: a run beyond the end of its row");
    EXPECT_EQ(errorOf("\2\2\0\x8\x9"s), "damaged HDR: a run beyond the end of its row");
    EXPECT_EQ(errorOf("\2\2\0\x8\0"s), "damaged HDR: a run beyond the end of its row");
    EXPECT_EQ(errorOf("\1\1\1\1"s), "damaged HDR: a run beyond the ends of its row");
    EXPECT_EQ(errorOf("abcd\1\1\1\x8"s), "damaged HDR: a run beyond the ends of its row");
    EXPECT_EQ(errorOf("abcd\1\1\1\0\1\1\1\0\1\1\1\0\1\1\1\0\1\1\1\0"s),
              "damaged HDR: a run beyond the ends of its row");
}

// Radiance: "-Y H +X W" is a picture by rows from its upper left; the other signs and orders mirror and turn it.
TEST(HdrTest, AllOrientationsAreTurnedUpright) {
    const TemporaryFolder folder;
    constexpr Size kSize = {12, 19};
    const std::vector<Texel> texels = SomeTexels(kSize);
    const Picture stored = ReadPicture(folder.Put("p", MakeHdr(kSize, texels, false)));
    const auto read = [&](const std::string& sides) {
        Bytes file = ToBytes("#?RADIANCE\n\n" + sides + "\n");
        for (const Texel& texel : texels)
            file.insert(file.end(), texel.begin(), texel.end());
        return ReadPicture(folder.Put("p", file));
    };
    ExpectTurned(read("-Y 19 +X 12"), stored, 1);
    ExpectTurned(read("-Y 19 -X 12"), stored, 2);
    ExpectTurned(read("+Y 19 -X 12"), stored, 3);
    ExpectTurned(read("+Y 19 +X 12"), stored, 4);
    ExpectTurned(read("+X 19 -Y 12"), stored, 5);
    ExpectTurned(read("-X 19 -Y 12"), stored, 6);
    ExpectTurned(read("-X 19 +Y 12"), stored, 7);
    ExpectTurned(read("+X 19 +Y 12"), stored, 8);
}

TEST(HdrTest, VariablesThatAreNotUsedAreNotes) {
    const TemporaryFolder folder;
    const auto read = [&](const std::string& variables) {
        return ReadPicture(folder.Put("p", ToBytes("#?RADIANCE\n" + variables + "\n-Y 1 +X 1\n\x80\x80\x80\x81")));
    };
    const Picture exposed = read("EXPOSURE=2\nEXPOSURE= +4.0\nCOLORCORR=1 .5 1\nGAMMA=2.2\n");
    EXPECT_EQ(exposed.samples, (std::vector<float>{1, 1, 1}));
    EXPECT_EQ(exposed.notes,
              (std::vector<std::string>{"its COLORCORR=1 .5 1 is not used: values are as the file holds them",
                                        "its GAMMA=2.2 is not used: values are as the file holds them",
                                        "its EXPOSURE of 8 is not divided out: values are as the file holds them"}));
    EXPECT_TRUE(read("EXPOSURE=2\nEXPOSURE=.5\nCOLORCORR=1 1 1\nGAMMA=1\n# EXPOSURE=7\n").notes.empty());
}

TEST(HdrTest, PrimariesAreKept) {
    const TemporaryFolder folder;
    const auto read = [&](const std::string& numbers) {
        return ReadPicture(folder.Put("p", ToBytes("#?RADIANCE\nPRIMARIES=" + numbers + "\n\n-Y 1 +X 1\nabcd")))
            .colorSpace.primaries;
    };
    EXPECT_EQ(read("0.64 0.33 0.29 0.6 0.15 0.06 0.333 0.333"),
              (Primaries{0.64f, 0.33f, 0.29f, 0.6f, 0.15f, 0.06f, 0.333f, 0.333f}));
    EXPECT_EQ(read("0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329"), std::nullopt);  // sRGB's
    EXPECT_EQ(read("0 0 0 0 0 0 0 0"), std::nullopt);                           // as Photoshop writes
    EXPECT_EQ(read("1 nan 0 1 0 0 1 1"), std::nullopt);
}

}  // namespace
}  // namespace boxcar::test
