#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <csetjmp>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "samples/files/codecs.h"
#include "samples/files/stb.h"

namespace boxcar {
namespace {

constexpr size_t kSignatureBytes = 8;
constexpr size_t kPaletteBytes = 256 * 3;

uint32_t BigEndian32(ByteView bytes) {
    return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | uint32_t{bytes[3]};
}

// length (4 bytes), type (4), data (length), checksum of type and data (4)
struct Chunk {
    std::string_view type;
    ByteView data;

    size_t EndIn(ByteView file) const { return static_cast<size_t>(data.data() - file.data()) + data.size() + 4; }
};

// The chunk at `offset`, whole and with the right checksum; stb looks at neither.
Chunk ReadChunk(ByteView file, size_t offset) {
    const ByteView rest = file.subspan(offset);
    if (rest.size() < 12 || rest.size() - 12 < BigEndian32(rest)) throw CutOff(FileFormat::Png);
    const uint32_t length = BigEndian32(rest);
    const Chunk chunk = {std::string_view(reinterpret_cast<const char*>(rest.data()) + 4, 4),
                         rest.subspan(8, length)};
    if (crc32(crc32(0, rest.data() + 4, 4), chunk.data.data(), length) != BigEndian32(rest.subspan(8 + length)))
        throw Error("damaged PNG: the checksum of the chunk at byte {} is wrong", offset);
    return chunk;
}

// stb leaves the palette entries that a file does not give uninitialised, though a texel may ask for them: makes them
// 0.
Bytes WithWholePalette(ByteView file, const Chunk& palette) {
    Bytes whole(file.begin(), file.end());
    const auto data = whole.begin() + (palette.data.data() - file.data());
    constexpr uint8_t kLength[4] = {0, 0, kPaletteBytes >> 8, kPaletteBytes & 255};
    std::copy(std::begin(kLength), std::end(kLength), data - 8);
    whole.insert(data + static_cast<ptrdiff_t>(palette.data.size()), kPaletteBytes - palette.data.size(), 0);
    return whole;
}

}  // namespace

Picture DecodePng(ByteView file, const PictureLimits& limits) {
    const Chunk header = ReadChunk(file, kSignatureBytes);
    if (header.type != "IHDR" || header.data.size() != 13)
        throw Error("damaged PNG: it does not begin with a header");
    const uint32_t width = BigEndian32(header.data);
    const uint32_t height = BigEndian32(header.data.subspan(4));
    RequireWithin(width, height, limits);
    const SampleType stored = header.data[8] == 16 ? SampleType::Unorm16 : SampleType::Unorm8;

    Bytes whole;
    for (Chunk chunk = header; chunk.type != "IEND"; chunk = ReadChunk(file, chunk.EndIn(file)))
        if (chunk.type == "PLTE" && chunk.data.size() < kPaletteBytes && chunk.data.size() % 3 == 0 && whole.empty())
            whole = WithWholePalette(file, chunk);
    return DecodeWithStb(whole.empty() ? file : ByteView(whole), FileFormat::Png, stored, width, height);
}

namespace {

// libpng reports by a callback that must not return and must not throw through C.
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
        writer->failure = text;
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

    bool Write(const Picture& picture, int bits, const uint8_t* rows) {
        constexpr int kColorTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                       PNG_COLOR_TYPE_RGB_ALPHA};
        if (setjmp(onError)) return false;
        png_set_write_fn(png, this, &Append, nullptr);
        png_set_IHDR(png, info, picture.widthTexels, picture.heightTexels, bits, kColorTypes[picture.channels - 1],
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png, info);
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
    std::string failure;
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
    if (!writer.Write(picture, sampleType == SampleType::Unorm8 ? 8 : 16, rows.data()))
        throw Error("PNG cannot hold it ({})", writer.failure);
    return std::move(writer.file);
}

}  // namespace boxcar
