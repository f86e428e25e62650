#include <libexif/exif-data.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

// jpeglib.h needs what is before it.
// clang-format off
#include <cstdio>
#include <jpeglib.h>
// clang-format on

#include "samples/files/codecs.h"
#include "samples/files/stb.h"

namespace boxcar {
namespace {

constexpr uint8_t kTemporary = 0x01;
constexpr uint8_t kFirstFrame = 0xc0;
constexpr uint8_t kLastFrame = 0xc2;
constexpr uint8_t kHuffmanTables = 0xc4;
constexpr uint8_t kFirstRestart = 0xd0;
constexpr uint8_t kStartOfImage = 0xd8;
constexpr uint8_t kEndOfImage = 0xd9;
constexpr uint8_t kStartOfScan = 0xda;

struct Size {
    uint64_t widthTexels = 0;
    uint64_t heightTexels = 0;
};

// Walks the segments as stb will, to refuse what stb 2.27 does not: Huffman tables of more than 256 codes, which it
// writes out of bounds; scans without number, each of which may take it as long as the whole picture; and fewer bits
// than blocks, which it fills up with grey. (Of a scan that breaks off later but is closed properly, nothing tells.)
// Returns what the frame header says.
//
// ITU-T T.81, annex B
Size ReadSize(ByteView file, const PictureLimits& limits) {
    constexpr int kMaxScans = 500;
    Size size;
    int scans = 0;
    size_t at = 0;
    const auto next = [&] {
        if (at == file.size()) throw CutOff(FileFormat::Jpeg);
        return file[at++];
    };
    for (;;) {
        while (next() != 0xff) {
        }
        uint8_t marker = next();
        while (marker == 0xff)
            marker = next();
        if (marker == kEndOfImage) return size;
        if (marker <= kTemporary || (marker >= kFirstRestart && marker <= kStartOfImage))
            continue;  // without a segment

        const size_t high = next();
        const size_t length = high << 8 | next();  // counts its own two bytes
        if (length < 2 || length - 2 > file.size() - at) throw CutOff(FileFormat::Jpeg);
        const ByteView segment = file.subspan(at, length - 2);
        at += segment.size();
        if (marker == kStartOfScan && ++scans > kMaxScans) throw Error("damaged JPEG: more than {} scans", kMaxScans);
        if (marker >= kFirstFrame && marker <= kLastFrame && segment.size() >= 5) {
            size.heightTexels = static_cast<uint64_t>(segment[1] << 8 | segment[2]);
            size.widthTexels = static_cast<uint64_t>(segment[3] << 8 | segment[4]);
            RequireWithin(size.widthTexels, size.heightTexels, limits);
            if (size.widthTexels * size.heightTexels / 64 > file.size() * 8) throw CutOff(FileFormat::Jpeg);
        }
        if (marker != kHuffmanTables) continue;
        for (ByteView tables = segment; !tables.empty();) {
            const size_t codes = tables.size() < 17 ? 0 : std::accumulate(&tables[1], tables.data() + 17, size_t{0});
            if (codes > 256 || tables.size() < 17 + codes)
                throw Error("damaged JPEG: a Huffman table is out of bounds");
            tables = tables.subspan(17 + codes);
        }
    }
}

// 1 to 8 as EXIF counts them; 1, upright, where the file does not say.
int Orientation(ByteView file) {
    const auto bytes = static_cast<unsigned>(std::min<size_t>(file.size(), std::numeric_limits<unsigned>::max()));
    const std::unique_ptr<ExifData, decltype(&exif_data_unref)> exif(exif_data_new_from_data(file.data(), bytes),
                                                                     &exif_data_unref);
    if (!exif) return 1;
    const ExifEntry* entry = exif_content_get_entry(exif->ifd[EXIF_IFD_0], EXIF_TAG_ORIENTATION);
    if (entry == nullptr || entry->format != EXIF_FORMAT_SHORT || entry->size < 2) return 1;
    const int orientation = exif_get_short(entry->data, exif_data_get_byte_order(exif.get()));
    return orientation >= 1 && orientation <= 8 ? orientation : 1;
}

// Exif 2.32, sect. 4.6.4.A: the orientation says at which edges of the scene the first row and the first column lie.
Picture Upright(Picture stored, int orientation) {
    if (orientation == 1) return stored;
    const bool swapAxes = orientation >= 5;
    const bool flipX = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool flipY = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;

    Picture upright =
        MakePicture(swapAxes ? stored.heightTexels : stored.widthTexels,
                    swapAxes ? stored.widthTexels : stored.heightTexels, stored.channels, stored.stored);
    auto to = upright.samples.begin();
    for (uint32_t y = 0; y < upright.heightTexels; ++y) {
        for (uint32_t x = 0; x < upright.widthTexels; ++x) {
            const uint32_t alongX = swapAxes ? y : x;
            const uint32_t alongY = swapAxes ? x : y;
            const size_t column = flipX ? stored.widthTexels - 1 - alongX : alongX;
            const size_t row = flipY ? stored.heightTexels - 1 - alongY : alongY;
            to = std::copy_n(&stored.samples[(row * stored.widthTexels + column) * stored.channels], stored.channels,
                             to);
        }
    }
    return upright;
}

}  // namespace

Picture DecodeJpeg(ByteView file, const PictureLimits& limits) {
    const Size size = ReadSize(file, limits);
    return Upright(DecodeWithStb(file, FileFormat::Jpeg, SampleType::Unorm8, size.widthTexels, size.heightTexels),
                   Orientation(file));
}

namespace {

// libjpeg reports by a callback that must not return and must not throw through C.
struct JpegWriter {
    JpegWriter() {
        jpeg.err = jpeg_std_error(&errors);
        errors.error_exit = &Fail;
        jpeg.client_data = this;
    }
    ~JpegWriter() {
        jpeg_destroy_compress(&jpeg);
        std::free(file);
    }
    JpegWriter(const JpegWriter&) = delete;
    JpegWriter& operator=(const JpegWriter&) = delete;

    static void Fail(j_common_ptr common) {
        auto* writer = static_cast<JpegWriter*>(common->client_data);
        common->err->format_message(common, writer->failure);
        std::longjmp(writer->onError, 1);
    }

    bool Write(const Picture& picture, const uint8_t* rows) {
        if (setjmp(onError)) return false;
        jpeg_create_compress(&jpeg);
        jpeg_mem_dest(&jpeg, &file, &fileBytes);
        jpeg.image_width = picture.widthTexels;
        jpeg.image_height = picture.heightTexels;
        jpeg.input_components = static_cast<int>(picture.channels);
        jpeg.in_color_space = picture.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
        jpeg_set_defaults(&jpeg);
        jpeg_set_quality(&jpeg, 95, TRUE);
        for (int i = 0; i < jpeg.num_components; ++i)
            jpeg.comp_info[i].h_samp_factor = jpeg.comp_info[i].v_samp_factor = 1;
        jpeg_start_compress(&jpeg, TRUE);
        const size_t rowBytes = size_t{picture.widthTexels} * picture.channels;
        while (jpeg.next_scanline < jpeg.image_height) {
            auto* row = const_cast<uint8_t*>(rows + jpeg.next_scanline * rowBytes);
            jpeg_write_scanlines(&jpeg, &row, 1);
        }
        jpeg_finish_compress(&jpeg);
        return true;
    }

    jpeg_compress_struct jpeg = {};
    jpeg_error_mgr errors = {};
    std::jmp_buf onError;
    unsigned char* file = nullptr;
    unsigned long fileBytes = 0;
    char failure[JMSG_LENGTH_MAX] = {};
};

}  // namespace

Bytes EncodeJpeg(const Picture& picture) {
    JpegWriter writer;
    if (!writer.Write(picture, ToCodes<uint8_t>(picture.samples).data()))
        throw Error("JPEG cannot hold it ({})", static_cast<const char*>(writer.failure));
    return Bytes(writer.file, writer.file + writer.fileBytes);
}

}  // namespace boxcar
