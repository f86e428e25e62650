#include <png.h>

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
        {"IDAT", {0x78, 0x01, 1, 3, 0, 0xfc, 0xff, 0, 0, 200, 0, 0, 0, 0}},
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

}  // namespace
}  // namespace boxcar::test
