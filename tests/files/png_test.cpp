#include <png.h>

#include <optional>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

Picture Read(const Bytes& bytes) {
    const TemporaryFolder folder;
    return ReadPicture(folder.Put("p.png", bytes));
}

std::vector<float> Over255(const std::vector<int>& codes) {
    std::vector<float> samples;
    for (const int code : codes)
        samples.push_back(static_cast<float>(code) / 255.0f);
    return samples;
}

TEST(PngTest, FewBitsBecomeEight) {
    // 1, 2 and 4 bits: the largest code is white, the others lie evenly between.
    const Picture one = Read(MakePng(PngFile{{3, 2}, PNG_COLOR_TYPE_GRAY, 1, {0b10100000, 0b01000000}}));
    ExpectSame(one, {3, 2, 1, SampleType::Unorm8, Over255({255, 0, 255, 0, 255, 0})});
    const Picture two = Read(MakePng(PngFile{{4, 1}, PNG_COLOR_TYPE_GRAY, 2, {0b00011011}}));
    ExpectSame(two, {4, 1, 1, SampleType::Unorm8, Over255({0, 85, 170, 255})});
    const Picture four = Read(MakePng(PngFile{{2, 1}, PNG_COLOR_TYPE_GRAY, 4, {0x1f}}));
    ExpectSame(four, {2, 1, 1, SampleType::Unorm8, Over255({17, 255})});
}

TEST(PngTest, PalettesBecomeColours) {
    const Bytes palette = {1, 2, 3, 40, 50, 60, 255, 0, 9};
    const Picture opaque = Read(MakePng(PngFile{{3, 1}, PNG_COLOR_TYPE_PALETTE, 8, {2, 0, 1}, false, palette}));
    ExpectSame(opaque, {3, 1, 3, SampleType::Unorm8, Over255({255, 0, 9, 1, 2, 3, 40, 50, 60})});
    const Picture clear =
        Read(MakePng(PngFile{{3, 1}, PNG_COLOR_TYPE_PALETTE, 2, {0b10000100}, false, palette, {7}}));
    ExpectSame(clear, {3, 1, 4, SampleType::Unorm8, Over255({255, 0, 9, 255, 1, 2, 3, 7, 40, 50, 60, 255})});
}

TEST(PngTest, ColoursThatThePaletteLacksAreBlack) {
    const std::vector<PngChunk> chunks = {
        PngHeader(2, 1, 8, PNG_COLOR_TYPE_PALETTE),
        {"PLTE", {10, 20, 30}},
        // zlib, one stored block: filter 0, index 0, index 200
        {"IDAT", {0x78, 0x01, 1, 3, 0, 0xfc, 0xff, 0, 0, 200, 0, 0xcb, 0, 0xc9}},
        {"IEND", {}},
    };
    ExpectSame(Read(MakePng(chunks)), {2, 1, 3, SampleType::Unorm8, Over255({10, 20, 30, 0, 0, 0})});
}

TEST(PngTest, AClearKeyBecomesAlpha) {
    PngFile grey{{2, 1}, PNG_COLOR_TYPE_GRAY, 8, {5, 6}};
    grey.hasKey = true;
    grey.key[0] = 6;
    ExpectSame(Read(MakePng(grey)), {2, 1, 2, SampleType::Unorm8, Over255({5, 255, 6, 0})});

    PngFile deep{{2, 1}, PNG_COLOR_TYPE_RGB, 16, {0, 1, 0, 2, 0, 3, 0, 1, 0, 2, 0, 4}};
    deep.hasKey = true;
    deep.key[0] = 1;
    deep.key[1] = 2;
    deep.key[2] = 4;
    std::vector<float> samples;
    for (const int code : {1, 2, 3, 65535, 1, 2, 4, 0})
        samples.push_back(static_cast<float>(code) / 65535.0f);
    ExpectSame(Read(MakePng(deep)), {2, 1, 4, SampleType::Unorm16, samples});
}

TEST(PngTest, InterlacingChangesNothing) {
    for (const Size size : kSizes) {
        for (const int bits : {8, 16}) {
            Bytes codes;
            for (uint32_t i = 0; i < size.width * size.height * 3 * static_cast<uint32_t>(bits) / 8; ++i)
                codes.push_back(static_cast<uint8_t>(i * 2654435761u >> 24));
            const Picture plain = Read(MakePng(PngFile{size, PNG_COLOR_TYPE_RGB, bits, codes, false}));
            ExpectSame(Read(MakePng(PngFile{size, PNG_COLOR_TYPE_RGB, bits, codes, true})), plain);
            EXPECT_EQ(plain.samples[0], static_cast<float>(codes[0] << (bits - 8)) / (bits == 8 ? 255.0f : 65535.0f) +
                                            (bits == 16 ? static_cast<float>(codes[1]) / 65535.0f : 0.0f));
        }
    }
}

TEST(PngTest, WritesTheBitsAndTheColourTypeThatThePictureHas) {
    const TemporaryFolder folder;
    constexpr uint8_t kColorTypes[] = {0, 4, 2, 6};
    for (uint32_t channels = 1; channels <= 4; ++channels) {
        for (const SampleType type : {SampleType::Unorm8, SampleType::Unorm16}) {
            WritePicture(PatternPicture({3, 2}, channels, type), folder.Path("p.png"), FileFormat::Png, type);
            const Bytes file = Contents(folder.Path("p.png"));
            EXPECT_EQ(file[24], type == SampleType::Unorm8 ? 8 : 16);
            EXPECT_EQ(file[25], kColorTypes[channels - 1]);
        }
    }
}

Bytes Plain(int colorType = PNG_COLOR_TYPE_RGB) {
    constexpr Size kSize = {12, 19};
    Bytes codes;
    const size_t channels = colorType == PNG_COLOR_TYPE_RGB ? 3 : 1;
    for (uint32_t i = 0; i < kSize.width * kSize.height * channels; ++i)
        codes.push_back(static_cast<uint8_t>(i * 2654435761u >> 24));
    return MakePng(PngFile{kSize, colorType, 8, codes});
}

Bytes BigEndianWords(const std::vector<uint32_t>& words) {
    Bytes bytes;
    for (const uint32_t word : words)
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes.push_back(static_cast<uint8_t>(word >> shift & 255));
    return bytes;
}

const PngChunk kSrgb = {"sRGB", {0}};
const PngChunk kLinearGamma = {"gAMA", BigEndianWords({100000})};
// Display P3: SMPTE EG 432-1
const std::vector<uint32_t> kP3 = {31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000};
const Primaries kP3Primaries = {0.68f, 0.32f, 0.265f, 0.69f, 0.15f, 0.06f, 0.3127f, 0.329f};

TEST(PngTest, IsTurnedUprightAsExifSaysWhereverItStands) {
    const Picture stored = Read(Plain());
    for (const bool atEnd : {false, true})
        for (uint8_t orientation = 1; orientation <= 8; ++orientation) {
            const PngChunk chunk = {"eXIf", TiffOfOrientation(orientation, orientation % 2 == 0)};
            ExpectTurned(Read(WithChunk(Plain(), chunk, atEnd)), stored, orientation);
        }
}

TEST(PngTest, GammaIsKeptBesideTheCodes) {
    const Picture plain = Read(Plain());
    const Picture linear = Read(WithChunk(Plain(), kLinearGamma));
    ExpectSame(linear, plain);
    EXPECT_EQ(linear.colorSpace.gamma, 1.0);
    EXPECT_EQ(plain.colorSpace.gamma, 0.0);
    for (const uint32_t srgbs : {45455u, 45450u, 45454u, 45460u})
        EXPECT_EQ(Read(WithChunk(Plain(), {"gAMA", BigEndianWords({srgbs})})).colorSpace.gamma, 0.0);
    EXPECT_EQ(Read(WithChunk(Plain(), {"gAMA", BigEndianWords({55556})})).colorSpace.gamma, 0.55556);
}

TEST(PngTest, PrimariesAreKeptWhereThereAreColors) {
    const PngChunk chunk = {"cHRM", BigEndianWords(kP3)};
    EXPECT_EQ(Read(WithChunk(Plain(), chunk)).colorSpace.primaries, kP3Primaries);
    EXPECT_EQ(Read(WithChunk(Plain(PNG_COLOR_TYPE_GRAY), chunk)).colorSpace.primaries, std::nullopt);
    const PngChunk srgbs = {"cHRM", BigEndianWords({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000})};
    EXPECT_EQ(Read(WithChunk(Plain(), srgbs)).colorSpace.primaries, std::nullopt);
}

TEST(PngTest, AProfileComesBeforeGammaAndPrimariesAndSoDoesSrgb) {
    const Bytes tagged = WithChunk(WithChunk(Plain(), kLinearGamma), {"cHRM", BigEndianWords(kP3)});
    const Bytes profile = MakeProfile("RGB ", 5000);
    const Picture profiled = Read(WithChunk(tagged, ProfileChunk(profile)));
    EXPECT_EQ(profiled.colorSpace.iccProfile, profile);
    const Picture srgb = Read(WithChunk(tagged, kSrgb));
    for (const Picture& picture : {profiled, srgb}) {
        EXPECT_EQ(picture.colorSpace.gamma, 0.0);
        EXPECT_EQ(picture.colorSpace.primaries, std::nullopt);
        EXPECT_TRUE(picture.notes.empty());
    }
    EXPECT_TRUE(srgb.colorSpace.iccProfile.empty());
}

TEST(PngTest, ColorSpacesComeBackAsTheyWereWritten) {
    const TemporaryFolder folder;
    for (const ColorSpace& space :
         {ColorSpace{0.55, {}, {}}, ColorSpace{0, kP3Primaries, {}}, ColorSpace{1, kP3Primaries, {}},
          ColorSpace{0, {}, MakeProfile("RGB ", 300'000)}}) {
        Picture picture = PatternPicture({3, 2}, 4, SampleType::Unorm8);
        picture.colorSpace = space;
        WritePicture(picture, folder.Path("p.png"), FileFormat::Png, SampleType::Unorm8);
        const Picture read = ReadPicture(folder.Path("p.png"));
        ExpectSame(read, picture);
        EXPECT_EQ(read.colorSpace.gamma, space.gamma);
        EXPECT_EQ(read.colorSpace.primaries, space.primaries);
        EXPECT_EQ(read.colorSpace.iccProfile, space.iccProfile);
    }
}

TEST(PngTest, WhatIsNotUsedIsANote) {
    EXPECT_EQ(Read(WithChunk(Plain(), {"cICP", {9, 16, 0, 1}})).notes,
              std::vector<std::string>{"its cICP chunk (primaries 9, transfer 16) is not used"});
    EXPECT_TRUE(Read(WithChunk(Plain(), {"cICP", {1, 13, 0, 1}})).notes.empty());
    Bytes damaged = MakeProfile("RGB ");
    damaged[36] = 'x';
    EXPECT_EQ(Read(WithChunk(Plain(), ProfileChunk(damaged))).notes,
              std::vector<std::string>{"its ICC profile is damaged and left out"});
}

TEST(PngTest, AProfileForOtherPicturesSaysSo) {
    const auto notesOf = [](int colorType, const char* space) {
        return Read(WithChunk(Plain(colorType), ProfileChunk(MakeProfile(space)))).notes;
    };
    using Notes = std::vector<std::string>;
    EXPECT_EQ(notesOf(PNG_COLOR_TYPE_GRAY, "RGB "),
              Notes{"its ICC profile is for RGB and is left out; the picture is gray here"});
    EXPECT_EQ(notesOf(PNG_COLOR_TYPE_RGB, "GRAY"),
              Notes{"its ICC profile is for GRAY and is left out; the picture is RGB here"});
    for (const std::string space : {"Lab", "CMYK"})
        EXPECT_EQ(notesOf(PNG_COLOR_TYPE_RGB, (space + " ").substr(0, 4).c_str()),
                  Notes{"its ICC profile is for " + space + " and is left out; the picture is RGB here"});
}

}  // namespace
}  // namespace boxcar::test
