#include "samples/files/picture.h"

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

struct RoundTrip {
    const char* name;
    FileFormat format;
    SampleType sampleType;
    uint32_t channels;
    friend std::ostream& operator<<(std::ostream& to, const RoundTrip& how) { return to << how.name; }
};

class RoundTripTest : public testing::TestWithParam<RoundTrip> {};

TEST_P(RoundTripTest, EverySampleComesBackAsItWas) {
    const RoundTrip& how = GetParam();
    const TemporaryFolder folder;
    for (const Size size : kSizes) {
        SCOPED_TRACE(fmt::format("{} x {}", size.width, size.height));
        const Picture picture = PatternPicture(size, how.channels, how.sampleType);
        const std::string path = folder.Path(how.name);
        WritePicture(picture, path, how.format, how.sampleType);
        ExpectSame(ReadPicture(path), picture);
    }
    EXPECT_EQ(folder.Names(), std::vector<std::string>{how.name});
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTripTest,
                         testing::Values(RoundTrip{"png_8_grey", FileFormat::Png, SampleType::Unorm8, 1},
                                         RoundTrip{"png_8_grey_alpha", FileFormat::Png, SampleType::Unorm8, 2},
                                         RoundTrip{"png_8_rgb", FileFormat::Png, SampleType::Unorm8, 3},
                                         RoundTrip{"png_8_rgba", FileFormat::Png, SampleType::Unorm8, 4},
                                         RoundTrip{"png_16_grey", FileFormat::Png, SampleType::Unorm16, 1},
                                         RoundTrip{"png_16_grey_alpha", FileFormat::Png, SampleType::Unorm16, 2},
                                         RoundTrip{"png_16_rgb", FileFormat::Png, SampleType::Unorm16, 3},
                                         RoundTrip{"png_16_rgba", FileFormat::Png, SampleType::Unorm16, 4},
                                         RoundTrip{"exr_grey", FileFormat::Exr, SampleType::Float32, 1},
                                         RoundTrip{"exr_grey_alpha", FileFormat::Exr, SampleType::Float32, 2},
                                         RoundTrip{"exr_rgb", FileFormat::Exr, SampleType::Float32, 3},
                                         RoundTrip{"exr_rgba", FileFormat::Exr, SampleType::Float32, 4},
                                         RoundTrip{"pfm_grey", FileFormat::Pfm, SampleType::Float32, 1},
                                         RoundTrip{"pfm_rgb", FileFormat::Pfm, SampleType::Float32, 3}),
                         testing::PrintToStringParamName());

// Every code there is, in a picture of one row to every 256 of them.
Picture AllCodes(SampleType stored) {
    const uint32_t count = stored == SampleType::Unorm8 ? 256 : 65536;
    Picture picture{256, count / 256, 1, stored, {}};
    for (uint32_t code = 0; code < count; ++code)
        picture.samples.push_back(static_cast<float>(code) / static_cast<float>(count - 1));
    return picture;
}

TEST(PictureTest, EveryCodeOf8And16BitsComesBackThroughPng) {
    const TemporaryFolder folder;
    for (const SampleType type : {SampleType::Unorm8, SampleType::Unorm16}) {
        const Picture picture = AllCodes(type);
        WritePicture(picture, folder.Path("codes.png"), FileFormat::Png, type);
        ExpectSame(ReadPicture(folder.Path("codes.png")), picture);
    }
}

TEST(PictureTest, IntegersAreClampedAndRoundedToNearest) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const TemporaryFolder folder;
    const Picture picture{9,
                          1,
                          1,
                          SampleType::Float32,
                          {-1.0f, 2.0f, kNaN, kInfinity, -kInfinity, 0.49f / 255, 0.51f / 255, 1e30f, 254.51f / 255}};
    WritePicture(picture, folder.Path("p.png"), FileFormat::Png, SampleType::Unorm8);
    const Picture read = ReadPicture(folder.Path("p.png"));
    EXPECT_EQ(read.samples, (std::vector<float>{0, 1, 0, 1, 0, 0, 1.0f / 255, 1, 1}));
}

TEST(PictureTest, FloatFormatsKeepWhatIntegersCannot) {
    const TemporaryFolder folder;
    const std::vector<float> samples = {-1e30f, 1e30f, std::numeric_limits<float>::infinity(), 1e-40f, -0.0f, 0.1f};
    const Picture picture{2, 3, 1, SampleType::Float32, samples};
    for (const FileFormat format : {FileFormat::Exr, FileFormat::Pfm}) {
        WritePicture(picture, folder.Path("p"), format, SampleType::Float32);
        EXPECT_EQ(ReadPicture(folder.Path("p")).samples, samples);
    }
}

TEST(PictureTest, JpegKeepsSmoothPicturesWithinTwoCodes) {
    const TemporaryFolder folder;
    for (const uint32_t channels : {1u, 3u}) {
        for (const Size size : kSizes) {
            SCOPED_TRACE(fmt::format("{} x {} x {}", size.width, size.height, channels));
            const Picture picture = SmoothPicture(size, channels);
            WritePicture(picture, folder.Path("p.jpg"), FileFormat::Jpeg, SampleType::Unorm8);
            const Picture read = ReadPicture(folder.Path("p.jpg"));
            EXPECT_EQ(read.widthTexels, size.width);
            EXPECT_EQ(read.heightTexels, size.height);
            EXPECT_EQ(read.channels, channels);
            EXPECT_EQ(read.stored, SampleType::Unorm8);
            ASSERT_EQ(read.samples.size(), picture.samples.size());
            for (size_t i = 0; i < read.samples.size(); ++i)
                ASSERT_NEAR(read.samples[i] * 255, picture.samples[i] * 255, 2.01) << "sample " << i;
        }
    }
}

TEST(PictureTest, NamesOfOutputsSayTheFormat) {
    EXPECT_EQ(FormatFromName("a.png"), FileFormat::Png);
    EXPECT_EQ(FormatFromName("a/b.c/d.JPG"), FileFormat::Jpeg);
    EXPECT_EQ(FormatFromName("a.jpeg"), FileFormat::Jpeg);
    EXPECT_EQ(FormatFromName("a.hdr"), FileFormat::Hdr);
    EXPECT_EQ(FormatFromName("a.Exr"), FileFormat::Exr);
    EXPECT_EQ(FormatFromName("a.b.pfm"), FileFormat::Pfm);
    for (const std::string name : {"a.tif", "png", "", "a.", "folder.png/a", "a.pngx"})
        EXPECT_EQ(ErrorOf([&] { FormatFromName(name); }),
                  name + ": the name says no format; an ending .png, .jpg, .jpeg, .exr or .pfm is expected");
}

TEST(PictureTest, WordsSayTheFormat) {
    EXPECT_EQ(FormatFromWord("png"), FileFormat::Png);
    EXPECT_EQ(FormatFromWord("PFM"), FileFormat::Pfm);
    EXPECT_EQ(ErrorOf([] { FormatFromWord(".png"); }),
              ".png: no format; png, jpg, jpeg, hdr, exr or pfm is expected");
}

TEST(PictureTest, PngKeeps16BitsAndJpegIs8AndTheOthersAreFloat) {
    EXPECT_EQ(SampleTypeFor(FileFormat::Png, SampleType::Unorm8), SampleType::Unorm8);
    EXPECT_EQ(SampleTypeFor(FileFormat::Png, SampleType::Unorm16), SampleType::Unorm16);
    EXPECT_EQ(SampleTypeFor(FileFormat::Png, SampleType::Float32), SampleType::Unorm8);
    EXPECT_EQ(SampleTypeFor(FileFormat::Jpeg, SampleType::Unorm16), SampleType::Unorm8);
    EXPECT_EQ(SampleTypeFor(FileFormat::Exr, SampleType::Unorm8), SampleType::Float32);
    EXPECT_EQ(SampleTypeFor(FileFormat::Pfm, SampleType::Unorm16), SampleType::Float32);
}

TEST(PictureTest, RefusesWhatTheFormatCannotHoldAndWritesNothing) {
    const TemporaryFolder folder;
    const std::string path = folder.Path("out");
    for (const uint32_t channels : {2u, 4u}) {
        const Picture picture = PatternPicture({2, 2}, channels, SampleType::Float32);
        EXPECT_EQ(ErrorOf([&] { WritePicture(picture, path, FileFormat::Jpeg, SampleType::Unorm8); }),
                  path + ": JPEG holds no alpha; PNG and EXR do");
        EXPECT_EQ(ErrorOf([&] { WritePicture(picture, path, FileFormat::Pfm, SampleType::Float32); }),
                  path + ": PFM holds no alpha; EXR does");
    }
    EXPECT_EQ(ErrorOf([&] { RequireWritable("-", FileFormat::Hdr, 3); }),
              "standard output: HDR is read, not written; .exr or .pfm holds the same");
    const Picture wide = PatternPicture({65501, 1}, 1, SampleType::Unorm8);
    EXPECT_EQ(ErrorOf([&] { WritePicture(wide, path, FileFormat::Jpeg, SampleType::Unorm8); }),
              path + ": JPEG cannot hold it (Maximum supported image dimension is 65500 pixels)");
    EXPECT_TRUE(folder.Names().empty());
}

TEST(PictureTest, RefusesSampleTypesThatTheFormatDoesNotHaveAsACallersMistake) {
    const Picture picture = PatternPicture({2, 2}, 3, SampleType::Float32);
    EXPECT_DEATH(WritePicture(picture, "-", FileFormat::Png, SampleType::Float32), "SampleTypeFor");
    EXPECT_DEATH(WritePicture(Picture{}, "-", FileFormat::Png, SampleType::Unorm8), "channels");
}

TEST(PictureTest, TheOutputMayBeTheInput) {
    const TemporaryFolder folder;
    const std::string path = folder.Path("same.png");
    const Picture picture = PatternPicture({12, 19}, 3, SampleType::Unorm8);
    WritePicture(picture, path, FileFormat::Png, SampleType::Unorm8);
    WritePicture(ReadPicture(path), path, FileFormat::Png, SampleType::Unorm8);
    ExpectSame(ReadPicture(path), picture);
    EXPECT_EQ(folder.Names(), std::vector<std::string>{"same.png"});
}

TEST(PictureTest, ReadsByContentWhateverTheNameSays) {
    const TemporaryFolder folder;
    const Picture picture = PatternPicture({3, 2}, 1, SampleType::Float32);
    WritePicture(picture, folder.Path("really_exr.png"), FileFormat::Exr, SampleType::Float32);
    ExpectSame(ReadPicture(folder.Path("really_exr.png")), picture);
    ExpectSame(ReadPicture(folder.Path("really_exr.png"), {}, FileFormat::Exr), picture);
}

TEST(PictureTest, BytesAfterThePictureAreNoFault) {
    const TemporaryFolder folder;
    for (NamedFile& file : SmallFiles()) {
        SCOPED_TRACE(file.name);
        const Picture picture = ReadPicture(folder.Put("plain", file.bytes));
        const Bytes more = ToBytes("more after it, as some cameras do");
        file.bytes.insert(file.bytes.end(), more.begin(), more.end());
        ExpectSame(ReadPicture(folder.Put("longer", file.bytes)), picture);
    }
}

// Puts another file in the place of a standard stream.
class Redirected {
public:
    Redirected(int stream, const std::string& path, int flags) : m_stream(stream), m_saved(::dup(stream)) {
        const int file = ::open(path.c_str(), flags, 0666);
        ::dup2(file, stream);
        ::close(file);
    }
    ~Redirected() {
        ::dup2(m_saved, m_stream);
        ::close(m_saved);
    }
    Redirected(const Redirected&) = delete;
    Redirected& operator=(const Redirected&) = delete;

private:
    int m_stream;
    int m_saved;
};

TEST(PictureTest, ADashIsStandardInputAndOutput) {
    const TemporaryFolder folder;
    const Picture picture = PatternPicture({12, 19}, 4, SampleType::Unorm16);
    std::fflush(stdout);
    {
        const Redirected out(STDOUT_FILENO, folder.Path("stream"), O_WRONLY | O_CREAT);
        WritePicture(picture, "-", FileFormat::Png, SampleType::Unorm16);
    }
    const Redirected in(STDIN_FILENO, folder.Path("stream"), O_RDONLY);
    ExpectSame(ReadPicture("-"), picture);
    EXPECT_EQ(ErrorOf([] { ReadPicture("-"); }),
              "standard input: the file is empty; a PNG, JPEG, HDR, EXR or PFM picture is expected");
}

TEST(PictureTest, AFullDiskBehindStandardOutputIsNoticed) {
    const Picture picture = PatternPicture({12, 19}, 1, SampleType::Unorm8);
    std::fflush(stdout);
    std::string error;
    {
        const Redirected out(STDOUT_FILENO, "/dev/full", O_WRONLY);
        error = ErrorOf([&] { WritePicture(picture, "-", FileFormat::Png, SampleType::Unorm8); });
    }
    EXPECT_EQ(error, "standard output: cannot be written: No space left on device");
}

}  // namespace
}  // namespace boxcar::test
