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

TEST(JpegTest, CmykBecomesRgb) {
    // As Adobe writes it: inverted, so that C = 255 is no ink. Then R = C K / 255.
    Bytes codes;
    for (uint32_t i = 0; i < kSize.width * kSize.height; ++i)
        codes.insert(codes.end(), {200, 100, 50, 128});
    Picture expected{kSize.width, kSize.height, 3, SampleType::Unorm8, {}};
    for (uint32_t i = 0; i < kSize.width * kSize.height; ++i)
        for (const int ink : {200, 100, 50})
            expected.samples.push_back(static_cast<float>(ink) * 128.0f / 255.0f / 255.0f);
    ExpectNear(Read(MakeJpeg({kSize, 4, codes})), expected, 2.01);
}

// Where the texel that is seen at (x, y) lies in the file, for pictures of `stored` size. Exif 2.32, sect. 4.6.4.A:
// "the 0th row is the visual .. of the image, the 0th column is the visual ..":
//   1 top left  2 top right  3 bottom right  4 bottom left  5 left top  6 right top  7 right bottom  8 left bottom
std::pair<uint32_t, uint32_t> ColumnAndRow(int orientation, Size stored, uint32_t x, uint32_t y) {
    const uint32_t w = stored.width - 1;
    const uint32_t h = stored.height - 1;
    switch (orientation) {
        case 1: return {x, y};
        case 2: return {w - x, y};
        case 3: return {w - x, h - y};
        case 4: return {x, h - y};
        case 5: return {y, x};          // rows run down from the left edge
        case 6: return {y, h - x};      // row 0 is the right edge, read from its top
        case 7: return {w - y, h - x};  // row 0 is the right edge, read from its bottom
        default: return {w - y, x};     // row 0 is the left edge, read from its bottom
    }
}

TEST(JpegTest, IsTurnedUprightAsExifSays) {
    const Bytes file = MakeJpeg({kSize, 3, Codes(SmoothPicture(kSize, 3))});
    const Picture stored = Read(file);
    for (const bool bigEndian : {false, true}) {
        for (uint8_t orientation = 1; orientation <= 8; ++orientation) {
            SCOPED_TRACE(fmt::format("orientation {}", orientation));
            const Picture upright = Read(WithOrientation(file, orientation, bigEndian));
            ASSERT_EQ(upright.widthTexels, orientation <= 4 ? kSize.width : kSize.height);
            ASSERT_EQ(upright.heightTexels, orientation <= 4 ? kSize.height : kSize.width);
            for (uint32_t y = 0; y < upright.heightTexels; ++y) {
                for (uint32_t x = 0; x < upright.widthTexels; ++x) {
                    const auto [column, row] = ColumnAndRow(orientation, kSize, x, y);
                    for (uint32_t c = 0; c < 3; ++c)
                        ASSERT_EQ(upright.samples[(y * upright.widthTexels + x) * 3 + c],
                                  stored.samples[(row * kSize.width + column) * 3 + c])
                            << x << ", " << y;
                }
            }
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
