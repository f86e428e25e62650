// What must not be read as a picture: each with its one line, none with a crash, a hang or a partial picture.
#include <fcntl.h>
#include <png.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <csignal>
#include <random>
#include <thread>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

// The line without the path that it begins with.
std::string ErrorFor(const Bytes& bytes, const PictureLimits& limits = {}, std::optional<FileFormat> format = {}) {
    const TemporaryFolder folder;
    const std::string path = folder.Put("p", bytes);
    const std::string error = ErrorOf([&] { ReadPicture(path, limits, format); });
    EXPECT_TRUE(error.starts_with(path + ": ")) << error;
    return error.substr(std::min(error.size(), path.size() + 2));
}

Bytes SmallFile(const std::string& name) {
    const std::vector<NamedFile> files = SmallFiles();
    const auto file = std::find_if(files.begin(), files.end(), [&](const NamedFile& f) { return f.name == name; });
    EXPECT_NE(file, files.end()) << name;
    return file == files.end() ? Bytes{} : file->bytes;
}

TEST(BadInputTest, WhatCannotBeReadIsNamedWithItsReason) {
    const TemporaryFolder folder;
    const std::string file = folder.Put("file", ToBytes("text"));
    const auto errorOf = [](const std::string& path) { return ErrorOf([&] { ReadPicture(path); }); };
    EXPECT_EQ(errorOf(folder.Path("none.png")),
              folder.Path("none.png") + ": cannot be read: No such file or directory");
    EXPECT_EQ(errorOf(file + "/p.png"), file + "/p.png: cannot be read: Not a directory");
    EXPECT_EQ(errorOf(folder.Path("")), folder.Path("") + ": a folder; a file is expected");
}

TEST(BadInputTest, WhatIsNoPictureIsRefused) {
    EXPECT_EQ(ErrorFor({}), "the file is empty; a PNG, JPEG, HDR, EXR or PFM picture is expected");
    for (const std::string text : {"GIF89a....", "P6\n1 1\n255\nabc", "PFX\n1 1\n", "\x89PN", "v/1", "# a text\n"})
        EXPECT_EQ(ErrorFor(ToBytes(text)), "no picture that is known; PNG, JPEG, HDR, EXR or PFM is expected");
}

TEST(BadInputTest, TheFormatThatIsAskedForIsInsistedOn) {
    EXPECT_EQ(ErrorFor(SmallFile("grey_jpg"), {}, FileFormat::Png), "JPEG inside; PNG is expected");
    EXPECT_EQ(ErrorFor(SmallFile("grey_pfm"), {}, FileFormat::Exr), "PFM inside; EXR is expected");
}

// An input without end: refused at its start if it is no picture, else as soon as it is longer than a picture can be.
TEST(BadInputTest, InputsWithoutEndAreRefused) {
    EXPECT_EQ(ErrorOf([] { ReadPicture("/dev/zero"); }),
              "/dev/zero: no picture that is known; PNG, JPEG, HDR, EXR or PFM is expected");

    const TemporaryFolder folder;
    const std::string pipe = folder.Path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::signal(SIGPIPE, SIG_IGN);
    std::thread writer([&] {
        const int file = ::open(pipe.c_str(), O_WRONLY);
        const Bytes start = ToBytes("PF\n2 2\n1\n");
        const Bytes more(1 << 16);
        ssize_t written = ::write(file, start.data(), start.size());
        while (written > 0)
            written = ::write(file, more.data(), more.size());
        ::close(file);
    });
    EXPECT_EQ(ErrorOf([&] {
                  ReadPicture(pipe, {16384, 1 << 20});
              }),
              pipe + ": longer than 65 MiB, the most that is read");
    writer.join();
}

// A header that says these sides, and little more.
struct SizedFile {
    std::string name;
    Bytes (*make)(uint32_t width, uint32_t height);
    friend std::ostream& operator<<(std::ostream& to, const SizedFile& file) { return to << file.name; }
};

Bytes SizedPng(uint32_t width, uint32_t height) {
    return MakePng({PngHeader(width, height, 8, PNG_COLOR_TYPE_RGB), {"IEND", {}}});
}

Bytes SizedJpeg(uint32_t width, uint32_t height) {
    Bytes file = MakeJpeg({{1, 1}, 1, {0}});
    size_t frame = 0;
    while (file[frame] != 0xff || file[frame + 1] != 0xc0)
        ++frame;
    file[frame + 5] = static_cast<uint8_t>(height >> 8);
    file[frame + 6] = static_cast<uint8_t>(height & 255);
    file[frame + 7] = static_cast<uint8_t>(width >> 8);
    file[frame + 8] = static_cast<uint8_t>(width & 255);
    return file;
}

Bytes SizedHdr(uint32_t width, uint32_t height) {
    return ToBytes(fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", height, width));
}

Bytes SizedPfm(uint32_t width, uint32_t height) {
    return ToBytes(fmt::format("PF\n{} {}\n-1\n", width, height));
}

Bytes SizedExr(uint32_t width, uint32_t height) {
    Bytes file = MakeExr({{1, 1}, {{"Y", 2, {0.0f}}}});
    const std::string name = "dataWindow";
    const auto window = std::search(file.begin(), file.end(), name.begin(), name.end()) + 11 + 6 + 4;
    for (const auto& [field, side] : {std::pair{2, width}, std::pair{3, height}})
        for (int byte = 0; byte < 4; ++byte)
            window[field * 4 + byte] = static_cast<uint8_t>((side - 1) >> (8 * byte) & 255);
    return file;
}

class SizedFileTest : public testing::TestWithParam<SizedFile> {};

TEST_P(SizedFileTest, SidesOverTheLimitAreRefused) {
    const auto& make = GetParam().make;
    EXPECT_EQ(ErrorFor(make(16385, 12)), "16385 x 12 texels; a side may be at most 16384");
    EXPECT_EQ(ErrorFor(make(1, 65535)), "1 x 65535 texels; a side may be at most 16384");
    EXPECT_EQ(ErrorFor(make(65535, 65535)), "65535 x 65535 texels; a side may be at most 16384");
    EXPECT_EQ(ErrorFor(make(13, 12), {12, 1 << 30}), "13 x 12 texels; a side may be at most 12");
}

TEST_P(SizedFileTest, MoreMemoryThanIsAllowedIsRefusedWithBothSizes) {
    const auto& make = GetParam().make;
    EXPECT_EQ(ErrorFor(make(8192, 8193)),
              "8192 x 8193 texels need 1025 MiB as RGBA32F; at most 1024 MiB are allowed");
    EXPECT_EQ(ErrorFor(make(16384, 16384)),
              "16384 x 16384 texels need 4096 MiB as RGBA32F; at most 1024 MiB are allowed");
    EXPECT_EQ(ErrorFor(make(256, 257), {16384, 1 << 20}),
              "256 x 257 texels need 2 MiB as RGBA32F; at most 1 MiB are allowed");
}

TEST_P(SizedFileTest, WithinTheLimitsAPictureThatIsNotThereIsRefused) {
    EXPECT_NE(ErrorFor(GetParam().make(4000, 4000)), "");
    EXPECT_NE(ErrorFor(GetParam().make(16384, 4096)), "");
}

INSTANTIATE_TEST_SUITE_P(Formats, SizedFileTest,
                         testing::Values(SizedFile{"Png", SizedPng}, SizedFile{"Jpeg", SizedJpeg},
                                         SizedFile{"Hdr", SizedHdr}, SizedFile{"Pfm", SizedPfm},
                                         SizedFile{"Exr", SizedExr}),
                         testing::PrintToStringParamName());

TEST(BadInputTest, SidesOfZeroAreRefused) {
    EXPECT_EQ(ErrorFor(SizedPng(0, 5)), "0 x 5 texels; a side must be at least 1");
    EXPECT_EQ(ErrorFor(SizedPng(5, 0)), "5 x 0 texels; a side must be at least 1");
    EXPECT_EQ(ErrorFor(SizedHdr(0, 5)), "0 x 5 texels; a side must be at least 1");
    EXPECT_EQ(ErrorFor(SizedPfm(5, 0)), "5 x 0 texels; a side must be at least 1");
    EXPECT_EQ(ErrorFor(SizedExr(0, 5)), "0 x 5 texels; a side must be at least 1");
    EXPECT_EQ(ErrorFor(SizedJpeg(0, 5)), "0 x 5 texels; a side must be at least 1");
    EXPECT_EQ(ErrorFor(SizedJpeg(5, 0)), "5 x 0 texels; a side must be at least 1");
}

TEST(BadInputTest, SidesBeyond32BitsAreRefused) {
    EXPECT_EQ(ErrorFor(SizedPng(0xffffffff, 0xffffffff)),
              "4294967295 x 4294967295 texels; a side may be at most 16384");
    EXPECT_EQ(ErrorFor(SizedExr(0x80000000, 0x7fffffff)),
              "2147483648 x 2147483647 texels; a side may be at most 16384");
    EXPECT_EQ(ErrorFor(ToBytes("PF\n99999999999999999999999 1\n-1\n")),
              "18446744073709551615 x 1 texels; a side may be at most 16384");
    EXPECT_EQ(ErrorFor(ToBytes("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999999999999999999 +X 1\n")),
              "1 x 18446744073709551615 texels; a side may be at most 16384");
}

TEST(BadInputTest, PngWithAWrongChecksumIsRefused) {
    Bytes file = SmallFile("tagged_png");
    for (const std::string type : {"IHDR", "gAMA", "iCCP", "IDAT", "eXIf", "IEND"}) {
        Bytes changed = file;
        const auto chunk = std::search(changed.begin(), changed.end(), type.begin(), type.end());
        chunk[4 + *(chunk - 2) * 256 + *(chunk - 1)] ^= 1;
        EXPECT_EQ(ErrorFor(changed), "damaged PNG, or a kind of PNG that is not read (" + type + ": CRC error)");
    }
    file = SmallFile("rgb8_png");
    file[60] ^= 1;
    EXPECT_TRUE(ErrorFor(file).starts_with("damaged PNG, or a kind of PNG that is not read (IDAT: "));
}

TEST(BadInputTest, PngOfAppleIsRefusedByName) {
    EXPECT_EQ(ErrorFor(MakePng({{"CgBI", {0x50, 0, 0x20, 2}}, PngHeader(1, 1, 8, PNG_COLOR_TYPE_RGB), {"IEND", {}}})),
              "an Apple CgBI PNG, as Xcode writes for iOS; a standard PNG is expected (pngcrush makes one)");
}

TEST(BadInputTest, PngThatUnpacksToTooLittleOrTooMuchIsRefused) {
    // stored zlib blocks: final, length, its complement, bytes; then their Adler-32
    const Bytes little = {0x78, 0x01, 1, 1, 0, 0xfe, 0xff, 0, 0, 1, 0, 1};
    EXPECT_EQ(ErrorFor(MakePng({PngHeader(2, 2, 8, PNG_COLOR_TYPE_GRAY), {"IDAT", little}, {"IEND", {}}})),
              "damaged PNG, or a kind of PNG that is not read (Not enough image data)");

    // 64 MB of zeros in 64 KB: a picture of 1 x 1 has no use for them
    Bytes zeros(64'000'000), packed(compressBound(zeros.size()));
    uLongf size = packed.size();
    ASSERT_EQ(compress(packed.data(), &size, zeros.data(), zeros.size()), Z_OK);
    packed.resize(size);
    EXPECT_EQ(ErrorFor(MakePng({PngHeader(1, 1, 8, PNG_COLOR_TYPE_GRAY), {"IDAT", packed}, {"IEND", {}}})),
              "damaged PNG, or a kind of PNG that is not read (IDAT: Too much image data)");
}

TEST(BadInputTest, JpegWithTablesOutOfBoundsIsRefused) {
    Bytes file = SmallFile("grey_jpg");
    size_t table = 0;
    while (file[table] != 0xff || file[table + 1] != 0xc4)
        ++table;
    std::fill_n(file.begin() + static_cast<ptrdiff_t>(table) + 5, 16, uint8_t{255});
    EXPECT_EQ(ErrorFor(file), "damaged JPEG, or a kind of JPEG that is not read (Bogus Huffman table definition)");
}

size_t FindMarker(const Bytes& file, uint8_t marker, size_t from = 0) {
    while (file[from] != 0xff || file[from + 1] != marker)
        ++from;
    return from;
}

TEST(BadInputTest, JpegKindsAreRefusedByName) {
    Bytes file = SmallFile("colour_jpg");
    const size_t frame = FindMarker(file, 0xc0);
    const auto errorWith = [&](size_t offset, uint8_t value) {
        Bytes changed = file;
        changed[frame + offset] = value;
        return ErrorFor(changed);
    };
    EXPECT_EQ(errorWith(4, 12), "a JPEG of 12 bits a sample; 8 are expected");
    EXPECT_EQ(errorWith(9, 2), "a JPEG of 2 components; 1, 3 or 4 are expected");
    Bytes inks = SmallFile("ycck_jpg");
    inks[FindMarker(inks, 0xee) + 15] = 9;
    EXPECT_EQ(ErrorFor(inks),
              "damaged JPEG, or a kind of JPEG that is not read (Unknown Adobe color transform code 9)");
    EXPECT_EQ(errorWith(1, 0xc3), "a lossless JPEG (frame 0xc3); a sequential or progressive one is expected");
    EXPECT_EQ(errorWith(1, 0xc5), "a hierarchical JPEG (frame 0xc5); a sequential or progressive one is expected");
    EXPECT_EQ(errorWith(1, 0xf7), "a JPEG-LS JPEG (frame 0xf7); a sequential or progressive one is expected");
}

// Someone has put an end marker where the data break off.
TEST(BadInputTest, JpegWhoseDataBreakOffBeforeTheirEndMarkerIsRefused) {
    for (const std::string name : {"grey_jpg", "colour_jpg", "chroma420_jpg", "progressive_jpg", "cmyk_jpg"}) {
        SCOPED_TRACE(name);
        const Bytes whole = SmallFile(name);
        for (size_t length = FindMarker(whole, 0xda) + 12; length < whole.size() - 2; ++length) {
            Bytes file(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(length));
            file.insert(file.end(), {0xff, 0xd9});
            const TemporaryFolder folder;
            ASSERT_THROW(ReadPicture(folder.Put("p", file)), Error) << length << " of " << whole.size() << " bytes";
        }
    }
}

TEST(BadInputTest, JpegThatLacksScansIsRefused) {
    JpegFile sequential{{12, 19}, 3, Bytes(12 * 19 * 3, 77)};
    sequential.componentScans = true;
    for (const Bytes& whole : {SmallFile("progressive_jpg"), MakeJpeg(sequential)}) {
        std::vector<size_t> scans;
        for (size_t at = 0; at + 1 < whole.size(); ++at)
            if (whole[at] == 0xff && whole[at + 1] == 0xda) scans.push_back(at);
        EXPECT_GE(scans.size(), 3u);
        for (const size_t scan : scans) {
            Bytes file(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(scan));
            file.insert(file.end(), {0xff, 0xd9});
            EXPECT_NE(ErrorFor(file), "");
        }
    }
}

TEST(BadInputTest, JpegOfEndlessScansIsRefused) {
    Bytes file = SmallFile("progressive_jpg");
    size_t scan = file.size();
    while (file[scan - 2] != 0xff || file[scan - 1] != 0xda)
        --scan;
    const Bytes last(file.begin() + static_cast<ptrdiff_t>(scan) - 2, file.end() - 2);
    for (int i = 0; i < 600; ++i)
        file.insert(file.end() - 2, last.begin(), last.end());
    EXPECT_EQ(ErrorFor(file), "damaged JPEG: more than 500 scans");
}

TEST(BadInputTest, ExrThatAsksForMoreMemoryThanItsTexelsIsRefused) {
    // The size of an attribute: "lineOrder", its type of the same name, then 4 bytes.
    Bytes attribute = SmallFile("lines0_exr");
    const std::string name("lineOrder\0lineOrder\0", 20);
    auto at = std::search(attribute.begin(), attribute.end(), name.begin(), name.end());
    at[23] = 0x7f;
    EXPECT_EQ(ErrorFor(attribute), "cut off: the EXR ends before its picture does");

    Bytes tiles = SmallFile("tiles0_exr");
    const std::string tileName("tiles\0tiledesc\0", 15);
    at = std::search(tiles.begin(), tiles.end(), tileName.begin(), tileName.end()) + 19;
    std::copy_n("\xff\xff\0\0\xff\xff\0", 7, at);  // 65535 x 65535
    EXPECT_EQ(ErrorFor(tiles), "its tiles or groups of lines take 40959 MiB; at most 1088 MiB are allowed");
}

// Their tables of offsets would take more than the file holds.
TEST(BadInputTest, ExrTablesThatTheFileDoesNotHoldAreRefusedBeforeTheyTakeMemory) {
    const auto withWindow = [](Bytes file, uint32_t side) {
        const std::string name = "dataWindow";
        const auto window = std::search(file.begin(), file.end(), name.begin(), name.end()) + 11 + 6 + 4;
        for (const int field : {2, 3})
            for (int byte = 0; byte < 4; ++byte)
                window[field * 4 + byte] = static_cast<uint8_t>((side - 1) >> (8 * byte) & 255);
        return file;
    };
    Bytes tiles = withWindow(SmallFile("tiles0_exr"), 8000);
    const std::string tileName("tiles\0tiledesc\0", 15);
    const auto at = std::search(tiles.begin(), tiles.end(), tileName.begin(), tileName.end()) + 19;
    std::copy_n("\1\0\0\0\1\0\0\0", 8, at);  // 64 million tiles of 1 x 1
    EXPECT_EQ(ErrorFor(tiles), "cut off: the EXR ends before its picture does");
    EXPECT_EQ(ErrorFor(withWindow(SmallFile("lines0_exr"), 8000)), "cut off: the EXR ends before its picture does");
}

// Everything that can be cut off is cut off, at every length.
class CutFileTest : public testing::TestWithParam<NamedFile> {};

TEST_P(CutFileTest, IsRefusedAtEveryLength) {
    const Bytes& whole = GetParam().bytes;
    const TemporaryFolder folder;
    ASSERT_NO_THROW(ReadPicture(folder.Put("p", whole)));
    for (size_t length = 0; length < whole.size(); ++length) {
        const std::string path = folder.Put("p", ByteView(whole).first(length));
        ASSERT_THROW(ReadPicture(path), Error) << length << " of " << whole.size() << " bytes";
    }
}

// Whatever the bytes are: a line, or a picture that is whole.
TEST_P(CutFileTest, DamagedAnywhereIsAWholePictureOrAnError) {
    const TemporaryFolder folder;
    std::mt19937 random(1);
    int pictures = 0, errors = 0;
    for (int i = 0; i < 400; ++i) {
        Bytes file = GetParam().bytes;
        for (int edits = 1 + static_cast<int>(random() % 4); edits > 0; --edits)
            file[random() % file.size()] = static_cast<uint8_t>(random() % 3 ? random() : 255);
        try {
            const Picture picture = ReadPicture(folder.Put("p", file), {2000, 16 << 20});
            ASSERT_EQ(picture.samples.size(),
                      uint64_t{picture.widthTexels} * picture.heightTexels * picture.channels);
            ++pictures;
        } catch (const Error& error) {
            ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            ++errors;
        }
    }
    EXPECT_EQ(pictures + errors, 400);
    EXPECT_GT(errors, 0);
}

INSTANTIATE_TEST_SUITE_P(Files, CutFileTest, testing::ValuesIn(SmallFiles()), testing::PrintToStringParamName());

}  // namespace
}  // namespace boxcar::test
