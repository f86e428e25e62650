// What the tests of samples/files share: folders that go away, pictures with known texels, and files of kinds that
// Boxcar reads but does not write, made with the formats' own libraries.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "samples/files/bytes.h"
#include "samples/files/picture.h"
#include "tests/support/temporary_folder.h"
#include "tools/base/error.h"

namespace boxcar::test {

struct Size {
    uint32_t width;
    uint32_t height;
};
constexpr Size kSizes[] = {{1, 1}, {1, 6}, {6, 1}, {12, 19}, {49, 2}};

Bytes Contents(const std::string& path);
Bytes ToBytes(std::string_view text);

// The text of the boxcar::Error that `work` throws; a failure of the test where it throws none.
template <typename Work>
std::string ErrorOf(Work work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "no Error was thrown";
    return {};
}

// A picture without symmetry: neighbours in every direction differ. Integers take codes from all of their range;
// floats go below 0 and above 1.
Picture PatternPicture(Size size, uint32_t channels, SampleType stored);

// Slow ramps, as JPEG keeps them.
Picture SmoothPicture(Size size, uint32_t channels);

// One file in bytes; `codes` are rows top to bottom, packed as PNG packs them, 16 bits big-endian.
struct PngFile {
    Size size;
    int colorType;  // PNG_COLOR_TYPE_..
    int bits;
    Bytes codes;
    bool interlaced = false;
    Bytes palette = {};       // RGB triples
    Bytes paletteAlpha = {};  // tRNS of a palette
    bool hasKey = false;      // tRNS otherwise: texels with the codes `key` are clear
    uint16_t key[3] = {};
};
Bytes MakePng(const PngFile& png);

// PNG by hand: chunks with right checksums, whatever they hold.
struct PngChunk {
    std::string type;
    Bytes data;
};
Bytes MakePng(const std::vector<PngChunk>& chunks);
// `png` with a chunk right after its header, or right before its end.
Bytes WithChunk(ByteView png, const PngChunk& chunk, bool atEnd = false);
PngChunk ProfileChunk(const Bytes& profile);  // iCCP
PngChunk PngHeader(uint32_t width, uint32_t height, uint8_t bits, uint8_t colorType);

struct JpegFile {
    Size size;
    int channels;  // 1 grey, 3 RGB, 4 CMYK, with Adobe's marker (inverted) unless that is left out
    Bytes codes;
    bool progressive = false;
    int chromaStep = 1;  // 2: 4:2:0
    bool arithmetic = false;
    int colorSpace = 0;  // as which it is stored, J_COLOR_SPACE; 0: as the library likes
    bool adobeMarker = true;
    bool componentScans = false;  // sequential: a scan for each component
    Bytes profile = {};           // ICC
};
Bytes MakeJpeg(const JpegFile& jpeg);

// An ICC profile that libpng takes: a header without tags, and then anything. space: "RGB ", "GRAY" or "CMYK".
Bytes MakeProfile(const std::string& space, size_t bytes = 300);

// The TIFF structure that EXIF data are, with an orientation; bigEndian is its byte order.
Bytes TiffOfOrientation(uint8_t orientation, bool bigEndian);

// Where the texel that is seen at (x, y) lies in a file of that orientation, for pictures of `stored` size: column
// and row.
std::pair<uint32_t, uint32_t> ColumnAndRow(int orientation, Size stored, uint32_t x, uint32_t y);

// `upright` is `stored` turned as the orientation says.
void ExpectTurned(const Picture& upright, const Picture& stored, int orientation);

// `jpeg` with an EXIF segment in front that holds the orientation; bigEndian is its byte order.
Bytes WithOrientation(ByteView jpeg, uint8_t orientation, bool bigEndian);

struct ExrFile {
    struct Channel {
        std::string name;
        int type;  // Imf::PixelType; `values` are converted to it
        std::vector<float> values;
        int sampling = 1;
    };
    Size size;
    std::vector<Channel> channels;
    int compression = 3;  // Imf::Compression; ZIP
    int minX = 0;         // of the data window
    int minY = 0;
    bool tiled = false;
    std::array<int, 4> display = {0, 0, -1, -1};  // the window's first and last texel, x y x y; as the data if empty
};
Bytes MakeExr(const ExrFile& exr);

// A file of parts by name, with a channel for each letter; the samples of part i are i + 1.
Bytes MakePartsExr(const std::vector<std::pair<std::string, std::string>>& namesAndChannels);

// Luminance and chroma, subsampled by the library; channels: 3, or 4 with alpha.
Bytes MakeChromaExr(Size size, uint32_t channels,
                    const std::function<std::array<float, 4>(uint32_t x, uint32_t y)>& colorAt);

// A file of RGBE texels, run-length packed as Radiance does where `packed`.
Bytes MakeHdr(Size size, const std::vector<std::array<uint8_t, 4>>& texels, bool packed);

// Whole files of every kind, small, to cut and to damage.
struct NamedFile {
    std::string name;
    Bytes bytes;
    friend std::ostream& operator<<(std::ostream& to, const NamedFile& file) { return to << file.name; }
};
std::vector<NamedFile> SmallFiles();

void ExpectSame(const Picture& got, const Picture& expected);

}  // namespace boxcar::test
