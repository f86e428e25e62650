#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <new>
#include <string_view>
#include <utility>

#include "samples/files/codecs.h"
#include "samples/files/orientation.h"

namespace boxcar {
namespace {

constexpr double kSrgbGamma = 0.45455;  // what PNG (3rd ed., sect. 11.3.2.2) has files of the sRGB curve say
constexpr double kSameGamma = 0.0005;

uint32_t BigEndian32(ByteView bytes) {
    return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | uint32_t{bytes[3]};
}

void AppendBigEndian32(Bytes& bytes, uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<uint8_t>(word >> shift & 255));
}

// Looks at the header before the library does, which takes memory for it and has no names for what is wrong.
//
// signature (8 bytes), length of the chunk (4), its type (4), width (4), height (4), ..
void RequireHeader(ByteView file, const PictureLimits& limits) {
    constexpr size_t kHeaderEnd = 8 + 4 + 4 + 13 + 4;
    if (file.size() < kHeaderEnd) throw CutOff(FileFormat::Png);
    const std::string_view type(reinterpret_cast<const char*>(file.data()) + 12, 4);
    if (type == "CgBI")
        throw Error("an Apple CgBI PNG, as Xcode writes for iOS; a standard PNG is expected (pngcrush makes one)");
    if (type != "IHDR" || BigEndian32(file.subspan(8)) != 13)
        throw Error("damaged PNG: it does not begin with a header");
    RequireWithin(BigEndian32(file.subspan(16)), BigEndian32(file.subspan(20)), limits);
}

// libpng reports by callbacks that must not throw through C; the one for errors must not return either. So each step
// is a function that says whether it has come to its end, and has no locals to destroy.
struct PngReader {
    explicit PngReader(ByteView file) : rest(file) {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &Fail, &Warn);
        if (png != nullptr) info = png_create_info_struct(png);
        if (info == nullptr) throw std::bad_alloc();
    }
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    static PngReader& Of(png_structp png) { return *static_cast<PngReader*>(png_get_error_ptr(png)); }

    static void Fail(png_structp png, png_const_charp text) {
        PngReader& reader = Of(png);
        std::snprintf(reader.failure, sizeof reader.failure, "%s", text);
        std::longjmp(reader.onError, 1);
    }

    static void Warn(png_structp png, png_const_charp text) {
        if (std::strstr(text, "Too much image data") != nullptr) Fail(png, text);
        if (std::strncmp(text, "iCCP: ", 6) == 0) Of(png).ReadWarning(text);
    }

    static void Take(png_structp png, png_bytep to, size_t bytes) {
        PngReader& reader = Of(png);
        reader.isCutOff = bytes > reader.rest.size();
        if (reader.isCutOff) Fail(png, "");
        std::memcpy(to, reader.rest.data(), bytes);
        reader.rest = reader.rest.subspan(bytes);
    }

    // "iCCP: profile 'NAME': 'RGB ': RGB color space not permitted on grayscale PNG", or ".. 'Lab ': invalid ICC
    // profile color space"
    void ReadWarning(std::string_view text) {
        hasBadProfile = true;
        const size_t reason = text.rfind("': ");
        if (reason >= 5 && reason != text.npos && text[reason - 5] == '\'' &&
            text.substr(reason).find("color space") != text.npos)
            text.copy(profileSpace, 4, reason - 4);
    }

    // Up to the texels, which are to be 8 or 16 bits of gray or color, with alpha or without.
    bool ReadHead(const PictureLimits& limits) {
        static constexpr png_byte kUnused[] = "tEXt\0zTXt\0iTXt\0sPLT\0hIST\0pCAL\0sCAL\0bKGD";
        static constexpr png_byte kKept[] = "cICP";
        if (setjmp(onError)) return false;
        png_set_read_fn(png, this, &Take);
        png_set_user_limits(png, limits.maxSideTexels, limits.maxSideTexels);
        png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kUnused, sizeof kUnused / 5);
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, kKept, 1);
        png_read_info(png, info);
        png_set_expand(png);
        passes = png_set_interlace_handling(png);
        png_read_update_info(png, info);
        return true;
    }

    // `rows`: bytes for one row, or where the file is interlaced, for all of them.
    bool ReadTexels(Picture& picture, uint8_t* rows) {
        if (setjmp(onError)) return false;
        const size_t rowBytes = png_get_rowbytes(png, info);
        float* to = picture.samples.data();
        for (int pass = 0; pass < passes; ++pass) {
            for (uint32_t y = 0; y < picture.heightTexels; ++y) {
                uint8_t* row = rows + (passes > 1 ? y * rowBytes : 0);
                png_read_row(png, row, nullptr);
                if (pass + 1 == passes) to = ToSamples(row, rowBytes, picture.stored, to);
            }
        }
        png_read_end(png, info);
        return true;
    }

    static float* ToSamples(const uint8_t* row, size_t rowBytes, SampleType stored, float* to) {
        if (stored == SampleType::Unorm8) {
            const auto& samples = SamplesOf8Bits();
            return std::transform(row, row + rowBytes, to, [&](uint8_t code) { return samples[code]; });
        }
        for (const uint8_t* end = row + rowBytes; row != end; row += 2)
            *to++ = static_cast<float>(row[0] << 8 | row[1]) / 65535.0f;
        return to;
    }

    [[noreturn]] void ThrowFailure() const {
        if (isCutOff) throw CutOff(FileFormat::Png);
        throw Unreadable(FileFormat::Png, failure);
    }

    png_structp png = nullptr;
    png_infop info = nullptr;
    ByteView rest;
    std::jmp_buf onError;
    int passes = 1;
    bool isCutOff = false;
    bool hasBadProfile = false;
    char profileSpace[5] = {};  // of a profile that is for other pictures
    char failure[128] = {};
};

// Precedence: PNG 3rd ed., sect. 4.3, but for cICP.
void ReadColorSpace(const PngReader& reader, Picture& picture) {
    png_unknown_chunkp chunks = nullptr;
    const int chunkCount = png_get_unknown_chunks(reader.png, reader.info, &chunks);
    for (const auto& chunk : std::span(chunks, static_cast<size_t>(chunkCount)))
        if (chunk.size >= 2 && !(chunk.data[0] == 1 && chunk.data[1] == 13))  // sRGB: ITU-T H.273, tables 2 and 3
            picture.notes.push_back(
                fmt::format("its cICP chunk (primaries {}, transfer {}) is not used", chunk.data[0], chunk.data[1]));

    png_charp name = nullptr;
    int compression = 0;
    png_bytep profile = nullptr;
    png_uint_32 profileBytes = 0;
    if (png_get_iCCP(reader.png, reader.info, &name, &compression, &profile, &profileBytes) != 0)
        return SetIccProfile(picture, ByteView(profile, profileBytes));
    if (reader.hasBadProfile) LeaveOutProfile(picture, reader.profileSpace);
    if (png_get_valid(reader.png, reader.info, PNG_INFO_sRGB) != 0) return;
    double gamma = 0;
    if (png_get_gAMA(reader.png, reader.info, &gamma) != 0 && std::abs(gamma - kSrgbGamma) > kSameGamma)
        picture.colorSpace.gamma = gamma;
    double red[2], green[2], blue[2], white[2];
    if (png_get_cHRM(reader.png, reader.info, &white[0], &white[1], &red[0], &red[1], &green[0], &green[1], &blue[0],
                     &blue[1]) != 0) {
        Primaries primaries;
        auto to = primaries.begin();
        for (const auto& color : {red, green, blue, white})
            to = std::transform(color, color + 2, to, [](double c) { return static_cast<float>(c); });
        SetPrimaries(picture, primaries);
    }
}

int ReadOrientation(const PngReader& reader) {
    png_uint_32 bytes = 0;
    png_bytep data = nullptr;
    if (png_get_eXIf_1(reader.png, reader.info, &bytes, &data) == 0) return 1;
    Bytes exif = {'E', 'x', 'i', 'f', 0, 0};
    exif.insert(exif.end(), data, data + bytes);
    return ExifOrientation(exif);
}

}  // namespace

Picture DecodePng(ByteView file, const PictureLimits& limits) {
    RequireHeader(file, limits);
    PngReader reader(file);
    if (!reader.ReadHead(limits)) reader.ThrowFailure();
    const uint32_t height = png_get_image_height(reader.png, reader.info);
    Picture picture =
        MakePicture(png_get_image_width(reader.png, reader.info), height, png_get_channels(reader.png, reader.info),
                    png_get_bit_depth(reader.png, reader.info) == 16 ? SampleType::Unorm16 : SampleType::Unorm8);
    Bytes rows(png_get_rowbytes(reader.png, reader.info) * (reader.passes > 1 ? height : 1));
    if (!reader.ReadTexels(picture, rows.data())) reader.ThrowFailure();
    ReadColorSpace(reader, picture);
    return Upright(std::move(picture), ReadOrientation(reader));
}

namespace {

struct PngChunk {
    const char* type;
    Bytes data;
};

// iCCP: a name, 0, method 0, zlib's stream. gAMA, cHRM: units of 1 / 100000, white first.
std::vector<PngChunk> ColorChunks(const ColorSpace& space) {
    const auto append = [](Bytes& bytes, double value) {
        AppendBigEndian32(bytes, static_cast<uint32_t>(std::lround(value * 100000)));
    };
    std::vector<PngChunk> chunks;
    if (!space.iccProfile.empty()) {
        constexpr char kName[] = "ICC";
        uLongf bytes = compressBound(space.iccProfile.size());
        Bytes& data = chunks.emplace_back(PngChunk{"iCCP", Bytes(sizeof kName + 1 + bytes)}).data;
        std::copy(kName, std::end(kName), data.begin());
        compress(&data[sizeof kName + 1], &bytes, space.iccProfile.data(), space.iccProfile.size());
        data.resize(sizeof kName + 1 + bytes);
        return chunks;
    }
    const bool hasPrimaries = space.primaries && LostColorSpace({0, space.primaries, {}}, FileFormat::Png).empty();
    if (space.gamma != 0 || hasPrimaries)
        append(chunks.emplace_back(PngChunk{"gAMA", {}}).data, space.gamma != 0 ? space.gamma : kSrgbGamma);
    if (hasPrimaries) {
        Bytes& data = chunks.emplace_back(PngChunk{"cHRM", {}}).data;
        for (const size_t i : {6, 7, 0, 1, 2, 3, 4, 5})
            append(data, (*space.primaries)[i]);
    }
    return chunks;
}

// As PngReader.
struct PngWriter {
    PngWriter() {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, &Fail, nullptr);
        if (png != nullptr) info = png_create_info_struct(png);
        if (info == nullptr) throw std::bad_alloc();
    }
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    static void Fail(png_structp png, png_const_charp text) {
        auto* writer = static_cast<PngWriter*>(png_get_error_ptr(png));
        std::snprintf(writer->failure, sizeof writer->failure, "%s", text);
        std::longjmp(writer->onError, 1);
    }

    static void Append(png_structp png, png_bytep data, size_t bytes) {
        auto* writer = static_cast<PngWriter*>(png_get_io_ptr(png));
        try {
            writer->file.insert(writer->file.end(), data, data + bytes);
            return;
        } catch (const std::bad_alloc&) {
        }
        png_error(png, "out of memory");
    }

    bool Write(const Picture& picture, int bits, std::span<const PngChunk> chunks, const uint8_t* rows) {
        constexpr int kColorTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                       PNG_COLOR_TYPE_RGB_ALPHA};
        if (setjmp(onError)) return false;
        png_set_write_fn(png, this, &Append, nullptr);
        png_set_IHDR(png, info, picture.widthTexels, picture.heightTexels, bits, kColorTypes[picture.channels - 1],
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png, info);
        for (const PngChunk& chunk :
             chunks)  // as they are: png_set_iCCP would refuse profiles for their small faults
            png_write_chunk(png, reinterpret_cast<png_const_bytep>(chunk.type), chunk.data.data(), chunk.data.size());
        const size_t rowBytes = size_t{picture.widthTexels} * picture.channels * static_cast<size_t>(bits) / 8;
        for (uint32_t y = 0; y < picture.heightTexels; ++y)
            png_write_row(png, rows + y * rowBytes);
        png_write_end(png, info);
        return true;
    }

    png_structp png = nullptr;
    png_infop info = nullptr;
    std::jmp_buf onError;
    Bytes file;
    char failure[128] = {};
};

}  // namespace

Bytes EncodePng(const Picture& picture, SampleType sampleType) {
    Bytes rows;
    if (sampleType == SampleType::Unorm8) {
        rows = ToCodes<uint8_t>(picture.samples);
    } else {
        rows.reserve(picture.samples.size() * 2);
        for (const uint16_t code : ToCodes<uint16_t>(picture.samples)) {
            rows.push_back(static_cast<uint8_t>(code >> 8));
            rows.push_back(static_cast<uint8_t>(code & 255));
        }
    }
    PngWriter writer;
    if (!writer.Write(picture, sampleType == SampleType::Unorm8 ? 8 : 16, ColorChunks(picture.colorSpace),
                      rows.data()))
        throw Error("PNG cannot hold it ({})", static_cast<const char*>(writer.failure));
    return std::move(writer.file);
}

}  // namespace boxcar
