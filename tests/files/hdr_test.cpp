#include <array>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

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
              path + ": damaged HDR, or a kind of HDR that is not read (unsupported format)");
    for (const std::string sides : {"+X 1 -Y 1", "-Y 1", "-Y 1 -X 1", "-Y x +X 1", "1 1"})
        EXPECT_EQ(
            errorOf("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + sides + "\n1234"),
            path + ": an HDR whose rows do not run from the top left; -Y HEIGHT +X WIDTH is expected in its header");
}

}  // namespace
}  // namespace boxcar::test
