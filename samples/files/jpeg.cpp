#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <set>
#include <utility>

// jpeglib.h needs what is before it.
// clang-format off
#include <cstdio>
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include "samples/files/codecs.h"
#include "samples/files/orientation.h"

namespace boxcar {
namespace {

constexpr uint8_t kTemporary = 0x01;
constexpr uint8_t kFirstFrame = 0xc0;
constexpr uint8_t kProgressiveFrame = 0xc2;
constexpr uint8_t kArithmeticFrame = 0xc9;
constexpr uint8_t kArithmeticProgressiveFrame = 0xca;
constexpr uint8_t kLastFrame = 0xcf;
constexpr uint8_t kFirstRestart = 0xd0;
constexpr uint8_t kStartOfImage = 0xd8;
constexpr uint8_t kEndOfImage = 0xd9;
constexpr uint8_t kStartOfScan = 0xda;
constexpr uint8_t kLosslessLsFrame = 0xf7;

// Huffman tables, an extension and arithmetic conditioning stand among the markers of frames.
bool IsFrame(uint8_t marker) {
    return (marker >= kFirstFrame && marker <= kLastFrame && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) ||
           marker == kLosslessLsFrame;
}

// precision (1 byte), height (2), width (2), components (1), ..
void RequireFrame(uint8_t marker, ByteView segment, uint64_t fileBytes, const PictureLimits& limits) {
    const bool isArithmetic = marker == kArithmeticFrame || marker == kArithmeticProgressiveFrame;
    if (marker > kProgressiveFrame && !isArithmetic)
        throw Error("a {} JPEG (frame 0x{:02x}); a sequential or progressive one is expected",
                    marker == kLosslessLsFrame                                             ? "JPEG-LS"
                    : marker == 0xc3 || marker == 0xc7 || marker == 0xcb || marker == 0xcf ? "lossless"
                                                                                           : "hierarchical",
                    marker);
    if (segment.size() < 6) throw CutOff(FileFormat::Jpeg);
    const auto height = static_cast<uint64_t>(segment[1] << 8 | segment[2]);
    const auto width = static_cast<uint64_t>(segment[3] << 8 | segment[4]);
    RequireWithin(width, height, limits);
    if (segment[0] != 8) throw Error("a JPEG of {} bits a sample; 8 are expected", segment[0]);
    if (segment[5] != 1 && segment[5] != 3 && segment[5] != 4)
        throw Error("a JPEG of {} components; 1, 3 or 4 are expected", segment[5]);
    // Huffman codes take a bit a block at least, arithmetic ones less.
    if (!isArithmetic && width * height / 64 > fileBytes * 8) throw CutOff(FileFormat::Jpeg);
}

// Walks the segments as the library will, to refuse what it does not: scans without number, each of which may take as
// long as the whole picture, and frames of which some components have no scan. Checks the frame before memory for it
// is taken.
//
// ITU-T T.81, annex B
void RequireSegments(ByteView file, const PictureLimits& limits) {
    constexpr int kMaxScans = 500;
    size_t components = 0;
    std::set<uint8_t> scanned;
    int scans = 0;
    size_t at = 0;
    const auto next = [&] {
        if (at == file.size()) throw CutOff(FileFormat::Jpeg);
        return file[at++];
    };
    for (;;) {
        at = static_cast<size_t>(std::find(file.begin() + static_cast<ptrdiff_t>(at), file.end(), 0xff) -
                                 file.begin());
        next();
        uint8_t marker = next();
        while (marker == 0xff)
            marker = next();
        if (marker == kEndOfImage) break;
        if (marker <= kTemporary || (marker >= kFirstRestart && marker <= kStartOfImage))
            continue;  // without a segment

        const size_t high = next();
        const size_t length = high << 8 | next();  // counts its own two bytes
        if (length < 2 || length - 2 > file.size() - at) throw CutOff(FileFormat::Jpeg);
        const ByteView segment = file.subspan(at, length - 2);
        at += segment.size();
        if (IsFrame(marker)) {
            RequireFrame(marker, segment, file.size(), limits);
            components = segment[5];
        }
        if (marker == kStartOfScan) {
            if (++scans > kMaxScans) throw Error("damaged JPEG: more than {} scans", kMaxScans);
            for (size_t i = 1; !segment.empty() && i <= segment[0] && 2 * i < segment.size(); ++i)
                scanned.insert(segment[2 * i - 1]);
        }
    }
    if (scanned.size() < components) throw CutOff(FileFormat::Jpeg);
}

// libjpeg reports by callbacks that must not throw through C; the one for errors must not return either. So each step
// is a function that says whether it has come to its end, and has no locals to destroy.
struct JpegReader {
    JpegReader() {
        jpeg.err = jpeg_std_error(&errors);
        errors.error_exit = &Fail;
        errors.emit_message = &Warn;
        jpeg.client_data = this;
    }
    ~JpegReader() {
        jpeg_destroy_decompress(&jpeg);
        std::free(profile);
    }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    static void Fail(j_common_ptr common) {
        auto* reader = static_cast<JpegReader*>(common->client_data);
        common->err->format_message(common, reader->failure);
        std::longjmp(reader->onError, 1);
    }

    // The library goes on after these with texels that it has made up.
    static void Warn(j_common_ptr common, int level) {
        constexpr int kFaults[] = {JWRN_HIT_MARKER,  JWRN_HUFF_BAD_CODE, JWRN_ARITH_BAD_CODE,
                                   JWRN_MUST_RESYNC, JWRN_JPEG_EOF,      JWRN_ADOBE_XFORM};
        if (level < 0 && std::ranges::count(kFaults, common->err->msg_code) > 0) Fail(common);
    }

    bool ReadHead(ByteView file, uint64_t maxBytes) {
        if (setjmp(onError)) return false;
        jpeg_create_decompress(&jpeg);
        jpeg.mem->max_memory_to_use = static_cast<long>(std::min<uint64_t>(maxBytes, LONG_MAX));
        jpeg_mem_src(&jpeg, file.data(), file.size());
        jpeg_save_markers(&jpeg, JPEG_APP0 + 1, 0xffff);
        jpeg_save_markers(&jpeg, JPEG_APP0 + 2, 0xffff);
        jpeg_read_header(&jpeg, TRUE);
        jpeg.out_color_space = jpeg.num_components == 1   ? JCS_GRAYSCALE
                               : jpeg.num_components == 3 ? JCS_RGB
                                                          : JCS_CMYK;
        jpeg_start_decompress(&jpeg);
        jpeg_read_icc_profile(&jpeg, &profile, &profileBytes);
        return true;
    }

    bool ReadTexels(Picture& picture, uint8_t* row) {
        if (setjmp(onError)) return false;
        const size_t rowBytes = size_t{jpeg.output_width} * static_cast<size_t>(jpeg.output_components);
        float* to = picture.samples.data();
        while (jpeg.output_scanline < jpeg.output_height) {
            jpeg_read_scanlines(&jpeg, &row, 1);
            if (jpeg.out_color_space == JCS_CMYK) InksToRgb(row);
            const auto& samples = SamplesOf8Bits();
            to = std::transform(row, row + (rowBytes / jpeg.output_components) * picture.channels, to,
                                [&](uint8_t code) { return samples[code]; });
        }
        if (LacksRefinement()) {
            jpeg.err->msg_code = JWRN_HIT_MARKER;
            Fail(reinterpret_cast<j_common_ptr>(&jpeg));
        }
        jpeg_finish_decompress(&jpeg);
        return true;
    }

    // In place: 4 bytes of ink a texel become 3. Adobe's are inverted: 255 is none.
    void InksToRgb(uint8_t* row) const {
        const uint8_t* from = row;
        const uint8_t invert = jpeg.saw_Adobe_marker ? 0 : 255;
        for (uint32_t x = 0; x < jpeg.output_width; ++x, from += 4) {
            const int white = from[3] ^ invert;
            for (int c = 0; c < 3; ++c)
                *row++ = static_cast<uint8_t>(((from[c] ^ invert) * white + 127) / 255);
        }
    }

    // Whether a progressive file ends before scans that its earlier ones need: coef_bits are the bits still missing
    // of each coefficient, -1 where no scan has it, as may be where all of them are 0.
    bool LacksRefinement() const {
        if (jpeg.coef_bits == nullptr) return false;
        for (int c = 0; c < jpeg.num_components; ++c)
            if (jpeg.coef_bits[c][0] < 0 ||
                std::any_of(jpeg.coef_bits[c], jpeg.coef_bits[c] + DCTSIZE2, [](int bits) { return bits > 0; }))
                return true;
        return false;
    }

    [[noreturn]] void ThrowFailure() const {
        if (errors.msg_code == JWRN_JPEG_EOF) throw CutOff(FileFormat::Jpeg);
        throw Unreadable(FileFormat::Jpeg, failure);
    }

    jpeg_decompress_struct jpeg = {};
    jpeg_error_mgr errors = {};
    std::jmp_buf onError;
    JOCTET* profile = nullptr;
    unsigned profileBytes = 0;
    char failure[JMSG_LENGTH_MAX] = {};
};

int ReadOrientation(const JpegReader& reader) {
    for (auto marker = reader.jpeg.marker_list; marker != nullptr; marker = marker->next)
        if (marker->marker == JPEG_APP0 + 1 && marker->data_length >= 6 &&
            std::memcmp(marker->data, "Exif\0", 6) == 0)
            return ExifOrientation(ByteView(marker->data, marker->data_length));
    return 1;
}

}  // namespace

Picture DecodeJpeg(ByteView file, const PictureLimits& limits) {
    RequireSegments(file, limits);
    JpegReader reader;
    if (!reader.ReadHead(file, MaxFileBytes(limits))) reader.ThrowFailure();
    const auto& jpeg = reader.jpeg;
    RequireWithin(jpeg.output_width, jpeg.output_height, limits);
    Picture picture =
        MakePicture(jpeg.output_width, jpeg.output_height, jpeg.num_components == 1 ? 1 : 3, SampleType::Unorm8);
    Bytes row(size_t{jpeg.output_width} * static_cast<size_t>(jpeg.output_components));
    if (reader.profile != nullptr) SetIccProfile(picture, ByteView(reader.profile, reader.profileBytes));
    const int orientation = ReadOrientation(reader);
    if (!reader.ReadTexels(picture, row.data())) reader.ThrowFailure();
    return Upright(std::move(picture), orientation);
}

namespace {

// As JpegReader.
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
        const auto& profile = picture.colorSpace.iccProfile;
        if (!profile.empty()) jpeg_write_icc_profile(&jpeg, profile.data(), static_cast<unsigned>(profile.size()));
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
