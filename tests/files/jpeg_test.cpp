// jpeglib.h needs what is before it.
// clang-format off
#include <cstdio>
#include <jpeglib.h>
// clang-format on

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

constexpr Size kSize = {12, 19};

Picture Read(const Bytes& bytes) {
    const TemporaryFolder folder;
    return ReadPicture(folder.Put("p.jpg", bytes));
}

Bytes Codes(const Picture& picture) {
    Bytes codes;
    for (const float sample : picture.samples)
        codes.push_back(static_cast<uint8_t>(sample * 255.0f + 0.5f));
    return codes;
}

void ExpectNear(const Picture& got, const Picture& expected, double codes) {
    ASSERT_EQ(got.samples.size(), expected.samples.size());
    EXPECT_EQ(got.channels, expected.channels);
    for (size_t i = 0; i < got.samples.size(); ++i)
        ASSERT_NEAR(got.samples[i] * 255, expected.samples[i] * 255, codes) << "sample " << i;
}

TEST(JpegTest, ReadsProgressiveAndSubsampledFiles) {
    const Picture picture = SmoothPicture(kSize, 3);
    ExpectNear(Read(MakeJpeg({kSize, 3, Codes(picture), true, 1})), picture, 2.01);
    ExpectNear(Read(MakeJpeg({kSize, 3, Codes(picture), false, 2})), picture, 5.01);
    ExpectNear(Read(MakeJpeg({kSize, 3, Codes(picture), true, 2})), picture, 5.01);
}

// Inks over paper: R = (1 - C) (1 - K). Adobe's are inverted, so that 255 is no ink.
TEST(JpegTest, InksBecomeRgb) {
    Bytes inks, inverted;
    Picture expected{kSize.width, kSize.height, 3, SampleType::Unorm8, {}};
    for (uint32_t i = 0; i < kSize.width * kSize.height; ++i) {
        for (const uint8_t ink : Bytes{55, 155, 205, 127}) {
            inks.push_back(ink);
            inverted.push_back(static_cast<uint8_t>(255 - ink));
        }
        for (const double ink : {55, 155, 205})
            expected.samples.push_back(static_cast<float>((1 - ink / 255) * (1 - 127.0 / 255)));
    }
    for (const bool progressive : {false, true}) {
        for (const int chromaStep : {1, 2}) {
            JpegFile file{kSize, 4, inverted, progressive, chromaStep};
            ExpectNear(Read(MakeJpeg(file)), expected, 2.01);
            file.colorSpace = JCS_YCCK;
            ExpectNear(Read(MakeJpeg(file)), expected, 2.01);
            file.colorSpace = 0;
            file.codes = inks;
            file.adobeMarker = false;
            ExpectNear(Read(MakeJpeg(file)), expected, 2.01);
        }
    }
}

// Neither is YCbCr: Adobe's marker says transform 0, or the components are called R, G and B.
TEST(JpegTest, RgbThatIsStoredAsRgbStaysSo) {
    const Picture picture = SmoothPicture(kSize, 3);
    JpegFile file{kSize, 3, Codes(picture)};
    file.colorSpace = JCS_RGB;
    for (const bool adobeMarker : {true, false}) {
        file.adobeMarker = adobeMarker;
        ExpectNear(Read(MakeJpeg(file)), picture, 2.01);
    }
}

// The coding is without loss, so the texels are those of the Huffman-coded file.
TEST(JpegTest, ArithmeticCodingChangesNothing) {
    for (const int channels : {1, 3, 4}) {
        for (const bool progressive : {false, true}) {
            JpegFile file{kSize, channels, Codes(SmoothPicture(kSize, static_cast<uint32_t>(channels))), progressive};
            const Picture huffman = Read(MakeJpeg(file));
            file.arithmetic = true;
            ExpectSame(Read(MakeJpeg(file)), huffman);
        }
    }
}

TEST(JpegTest, AScanForEachComponentChangesNothing) {
    JpegFile file{kSize, 3, Codes(SmoothPicture(kSize, 3)), false, 2};
    const Picture picture = Read(MakeJpeg(file));
    file.componentScans = true;
    ExpectSame(Read(MakeJpeg(file)), picture);
}

TEST(JpegTest, TheIccProfileIsReadAndWritten) {
    const TemporaryFolder folder;
    for (const uint32_t channels : {1u, 3u}) {
        // 65519 bytes are the most that one segment holds
        for (const size_t bytes : {size_t{300}, size_t{70'000}, size_t{200'000}}) {
            JpegFile file{kSize, static_cast<int>(channels), Codes(SmoothPicture(kSize, channels))};
            file.profile = MakeProfile(channels == 1 ? "GRAY" : "RGB ", bytes);
            const Picture read = Read(MakeJpeg(file));
            EXPECT_EQ(read.colorSpace.iccProfile, file.profile);
            EXPECT_TRUE(read.notes.empty());
            for (const FileFormat format : {FileFormat::Jpeg, FileFormat::Png}) {
                WritePicture(read, folder.Path("p"), format, SampleType::Unorm8);
                EXPECT_EQ(ReadPicture(folder.Path("p")).colorSpace.iccProfile, file.profile);
            }
        }
    }
}

TEST(JpegTest, AProfileThatIsNotForThePictureIsANote) {
    JpegFile file{kSize, 4, Codes(SmoothPicture(kSize, 4))};
    file.profile = MakeProfile("CMYK");
    const Picture inks = Read(MakeJpeg(file));
    EXPECT_TRUE(inks.colorSpace.iccProfile.empty());
    EXPECT_EQ(inks.notes,
              std::vector<std::string>{"its ICC profile is for CMYK and is left out; the picture is RGB here"});
    file = {kSize, 1, Codes(SmoothPicture(kSize, 1))};
    file.profile = MakeProfile("RGB ");
    EXPECT_EQ(Read(MakeJpeg(file)).notes,
              std::vector<std::string>{"its ICC profile is for RGB and is left out; the picture is gray here"});
    file.profile = Bytes(140, 7);
    EXPECT_EQ(Read(MakeJpeg(file)).notes, std::vector<std::string>{"its ICC profile is damaged and left out"});
}

TEST(JpegTest, IsTurnedUprightAsExifSays) {
    const Bytes file = MakeJpeg({kSize, 3, Codes(SmoothPicture(kSize, 3))});
    const Picture stored = Read(file);
    for (const bool bigEndian : {false, true}) {
        for (uint8_t orientation = 1; orientation <= 8; ++orientation) {
            SCOPED_TRACE(fmt::format("orientation {}", orientation));
            ExpectTurned(Read(WithOrientation(file, orientation, bigEndian)), stored, orientation);
        }
    }
}

TEST(JpegTest, AnOrientationThatIsNoneIsUpright) {
    const Bytes file = MakeJpeg({kSize, 1, Codes(SmoothPicture(kSize, 1))});
    for (const uint8_t orientation : Bytes{0, 9, 255})
        ExpectSame(Read(WithOrientation(file, orientation, true)), Read(file));
}

TEST(JpegTest, WritesColourWithoutSubsampling) {
    const TemporaryFolder folder;
    WritePicture(SmoothPicture(kSize, 3), folder.Path("p.jpg"), FileFormat::Jpeg, SampleType::Unorm8);
    const Bytes file = Contents(folder.Path("p.jpg"));
    size_t frame = 0;
    while (file[frame] != 0xff || file[frame + 1] != 0xc0)
        ++frame;
    // marker, length, precision, height, width, 3 components of (id, sampling, table)
    for (const size_t component : {0u, 1u, 2u})
        EXPECT_EQ(file[frame + 10 + 3 * component + 1], 0x11);
}

}  // namespace
}  // namespace boxcar::test
