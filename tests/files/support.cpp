#include "tests/files/support.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <png.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

// jpeglib.h needs what is before it.
// clang-format off
#include <cstdio>
#include <jpeglib.h>
// clang-format on

namespace boxcar::test {

Bytes Contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

Bytes ToBytes(std::string_view text) {
    return Bytes(text.begin(), text.end());
}

Picture PatternPicture(Size size, uint32_t channels, SampleType stored) {
    Picture picture{size.width, size.height, channels, stored, {}};
    const size_t count = size_t{size.width} * size.height * channels;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t code = (i * 2654435761u) >> 16;  // Knuth's multiplicative hash
        switch (stored) {
            case SampleType::Unorm8: picture.samples.push_back(static_cast<float>(code & 255) / 255.0f); break;
            case SampleType::Unorm16: picture.samples.push_back(static_cast<float>(code) / 65535.0f); break;
            case SampleType::Float32: picture.samples.push_back((static_cast<float>(code) - 9999.0f) / 333.0f); break;
        }
    }
    return picture;
}

Picture SmoothPicture(Size size, uint32_t channels) {
    Picture picture{size.width, size.height, channels, SampleType::Unorm8, {}};
    for (uint32_t y = 0; y < size.height; ++y)
        for (uint32_t x = 0; x < size.width; ++x)
            for (uint32_t c = 0; c < channels; ++c)
                picture.samples.push_back(static_cast<float>(20 + 3 * x + (c + 2) * y) / 255.0f);
    return picture;
}

Bytes MakePng(const PngFile& png) {
    Bytes file;
    png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(writer);
    png_set_write_fn(
        writer, &file,
        [](png_structp self, png_bytep data, size_t count) {
            auto* to = static_cast<Bytes*>(png_get_io_ptr(self));
            to->insert(to->end(), data, data + count);
        },
        nullptr);
    png_set_IHDR(writer, info, png.size.width, png.size.height, png.bits, png.colorType,
                 png.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (!png.palette.empty())
        png_set_PLTE(writer, info, reinterpret_cast<png_const_colorp>(png.palette.data()),
                     static_cast<int>(png.palette.size() / 3));
    if (!png.paletteAlpha.empty())
        png_set_tRNS(writer, info, png.paletteAlpha.data(), static_cast<int>(png.paletteAlpha.size()), nullptr);
    if (png.hasKey) {
        const png_color_16 key = {0, png.key[0], png.key[1], png.key[2], png.key[0]};
        png_set_tRNS(writer, info, nullptr, 0, &key);
    }
    const size_t rowBytes = png.codes.size() / png.size.height;
    std::vector<png_bytep> rows;
    for (uint32_t y = 0; y < png.size.height; ++y)
        rows.push_back(const_cast<png_bytep>(&png.codes[y * rowBytes]));
    png_set_rows(writer, info, rows.data());
    png_write_png(writer, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&writer, &info);
    return file;
}

namespace {

void AppendBigEndian(Bytes& bytes, uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<uint8_t>(word >> shift & 255));
}

}  // namespace

Bytes MakePng(const std::vector<PngChunk>& chunks) {
    Bytes file = ToBytes("\x89PNG\r\n\x1a\n");
    for (const PngChunk& chunk : chunks) {
        Bytes body = ToBytes(chunk.type);
        body.insert(body.end(), chunk.data.begin(), chunk.data.end());
        AppendBigEndian(file, static_cast<uint32_t>(chunk.data.size()));
        file.insert(file.end(), body.begin(), body.end());
        AppendBigEndian(file, static_cast<uint32_t>(crc32(0, body.data(), static_cast<uInt>(body.size()))));
    }
    return file;
}

Bytes WithChunk(ByteView png, const PngChunk& chunk, bool atEnd) {
    constexpr ptrdiff_t kSignatureBytes = 8, kHeaderEnd = kSignatureBytes + 25, kEndBytes = 12;
    const Bytes one = MakePng(std::vector{chunk});
    Bytes file(png.begin(), png.end());
    file.insert(atEnd ? file.end() - kEndBytes : file.begin() + kHeaderEnd, one.begin() + kSignatureBytes, one.end());
    return file;
}

PngChunk ProfileChunk(const Bytes& profile) {
    constexpr size_t kNameBytes = 3;  // "n", 0, and the method
    uLongf bytes = compressBound(profile.size());
    PngChunk chunk{"iCCP", Bytes(kNameBytes + bytes)};
    chunk.data[0] = 'n';
    compress(&chunk.data[kNameBytes], &bytes, profile.data(), profile.size());
    chunk.data.resize(kNameBytes + bytes);
    return chunk;
}

PngChunk PngHeader(uint32_t width, uint32_t height, uint8_t bits, uint8_t colorType) {
    PngChunk header{"IHDR", {}};
    AppendBigEndian(header.data, width);
    AppendBigEndian(header.data, height);
    header.data.insert(header.data.end(), {bits, colorType, 0, 0, 0});
    return header;
}

Bytes MakeJpeg(const JpegFile& file) {
    jpeg_compress_struct jpeg;
    jpeg_error_mgr errors;
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* data = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &data, &size);
    jpeg.image_width = file.size.width;
    jpeg.image_height = file.size.height;
    jpeg.input_components = file.channels;
    jpeg.in_color_space = file.channels == 1 ? JCS_GRAYSCALE : file.channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 95, TRUE);
    if (file.colorSpace != 0) jpeg_set_colorspace(&jpeg, static_cast<J_COLOR_SPACE>(file.colorSpace));
    if (!file.adobeMarker) jpeg.write_Adobe_marker = FALSE;
    jpeg.arith_code = file.arithmetic ? TRUE : FALSE;
    jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = file.chromaStep;
    if (file.progressive) jpeg_simple_progression(&jpeg);
    std::vector<jpeg_scan_info> scans;
    for (int c = 0; c < jpeg.num_components; ++c)
        scans.push_back({1, {c}, 0, DCTSIZE2 - 1, 0, 0});
    if (file.componentScans) {
        jpeg.scan_info = scans.data();
        jpeg.num_scans = jpeg.num_components;
    }
    jpeg_start_compress(&jpeg, TRUE);
    if (!file.profile.empty())
        jpeg_write_icc_profile(&jpeg, file.profile.data(), static_cast<unsigned>(file.profile.size()));
    const size_t rowBytes = file.codes.size() / file.size.height;
    while (jpeg.next_scanline < jpeg.image_height) {
        auto* row = const_cast<JSAMPROW>(&file.codes[jpeg.next_scanline * rowBytes]);
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    Bytes bytes(data, data + size);
    std::free(data);
    return bytes;
}

Bytes MakeProfile(const std::string& space, size_t bytes) {
    Bytes profile(bytes);
    const auto put = [&](size_t at, std::string_view text) {
        std::copy(text.begin(), text.end(), profile.begin() + static_cast<ptrdiff_t>(at));
    };
    for (size_t i = 0; i < 4; ++i)
        profile[i] = static_cast<uint8_t>(bytes >> (24 - 8 * i) & 255);
    put(8, "\2");
    put(12, "mntr" + space + "XYZ ");
    put(36, "acsp");
    put(70, "\xf6\xd6");  // D50 as X Y Z of 16.16 bits
    put(73, "\1");
    put(78, "\xd3\x2d");
    for (size_t i = 132; i < bytes; ++i)
        profile[i] = static_cast<uint8_t>(i * 2654435761u >> 24);
    return profile;
}

// Exif 2.32, sect. 4.6.4.A: "the 0th row is the visual .. of the image, the 0th column is the visual ..":
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

void ExpectTurned(const Picture& upright, const Picture& stored, int orientation) {
    const Size size = {stored.widthTexels, stored.heightTexels};
    ASSERT_EQ(upright.widthTexels, orientation <= 4 ? size.width : size.height);
    ASSERT_EQ(upright.heightTexels, orientation <= 4 ? size.height : size.width);
    ASSERT_EQ(upright.channels, stored.channels);
    for (uint32_t y = 0; y < upright.heightTexels; ++y) {
        for (uint32_t x = 0; x < upright.widthTexels; ++x) {
            const auto [column, row] = ColumnAndRow(orientation, size, x, y);
            for (uint32_t c = 0; c < stored.channels; ++c)
                ASSERT_EQ(upright.samples[(y * upright.widthTexels + x) * stored.channels + c],
                          stored.samples[(row * size.width + column) * stored.channels + c])
                    << x << ", " << y;
        }
    }
}

Bytes TiffOfOrientation(uint8_t orientation, bool bigEndian) {
    const Bytes big = {'M', 'M', 0, 42, 0, 0, 0,           8, 0, 1, 0x01, 0x12, 0,
                       3,   0,   0, 0,  1, 0, orientation, 0, 0, 0, 0,    0,    0};
    const Bytes little = {'I', 'I', 42, 0, 8, 0,           0, 0, 1, 0, 0x12, 0x01, 3,
                          0,   1,   0,  0, 0, orientation, 0, 0, 0, 0, 0,    0,    0};
    return bigEndian ? big : little;
}

Bytes WithOrientation(ByteView jpeg, uint8_t orientation, bool bigEndian) {
    Bytes segment = {0xff, 0xe1, 0, 34, 'E', 'x', 'i', 'f', 0, 0};
    const Bytes tiff = TiffOfOrientation(orientation, bigEndian);
    segment.insert(segment.end(), tiff.begin(), tiff.end());
    Bytes file(jpeg.begin(), jpeg.end());
    file.insert(file.begin() + 2, segment.begin(), segment.end());
    return file;
}

namespace {

class BytesStream : public Imf::OStream {
public:
    BytesStream() : OStream("test") {}
    void write(const char* data, int count) override {
        const size_t end = m_at + static_cast<size_t>(count);
        if (end > bytes.size()) bytes.resize(end);
        std::copy(data, data + count, bytes.begin() + static_cast<ptrdiff_t>(m_at));
        m_at = end;
    }
    uint64_t tellp() override { return m_at; }
    void seekp(uint64_t at) override { m_at = at; }

    Bytes bytes;

private:
    size_t m_at = 0;
};

}  // namespace

Bytes MakeExr(const ExrFile& exr) {
    const Imath::Box2i window({exr.minX, exr.minY}, {exr.minX + static_cast<int>(exr.size.width) - 1,
                                                     exr.minY + static_cast<int>(exr.size.height) - 1});
    const Imath::Box2i display({exr.display[0], exr.display[1]}, {exr.display[2], exr.display[3]});
    Imf::Header header(display.isEmpty() ? window : display, window);
    header.compression() = static_cast<Imf::Compression>(exr.compression);
    Imf::FrameBuffer frame;
    std::vector<std::vector<uint8_t>> storage;
    for (const ExrFile::Channel& channel : exr.channels) {
        const auto type = static_cast<Imf::PixelType>(channel.type);
        const size_t sampleBytes = type == Imf::HALF ? 2 : 4;
        std::vector<uint8_t>& samples = storage.emplace_back();
        for (const float value : channel.values) {
            const half asHalf(value);
            const auto asUint = static_cast<unsigned>(value);
            const void* from = type == Imf::HALF   ? static_cast<const void*>(&asHalf)
                               : type == Imf::UINT ? static_cast<const void*>(&asUint)
                                                   : static_cast<const void*>(&value);
            const auto* bytes = static_cast<const uint8_t*>(from);
            samples.insert(samples.end(), bytes, bytes + sampleBytes);
        }
        header.channels().insert(channel.name, Imf::Channel(type, channel.sampling, channel.sampling));
        const size_t rowSamples = exr.size.width / static_cast<size_t>(channel.sampling);
        frame.insert(channel.name, Imf::Slice::Make(type, samples.data(), window, sampleBytes,
                                                    sampleBytes * rowSamples, channel.sampling, channel.sampling));
    }
    BytesStream stream;
    if (exr.tiled) {
        header.setTileDescription(Imf::TileDescription(8, 8, Imf::ONE_LEVEL));
        Imf::TiledOutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(static_cast<int>(exr.size.height));
    }
    return stream.bytes;
}

Bytes MakePartsExr(const std::vector<std::pair<std::string, std::string>>& namesAndChannels) {
    constexpr int kSide = 2;
    std::vector<Imf::Header> headers;
    for (const auto& [name, channels] : namesAndChannels) {
        Imf::Header& header = headers.emplace_back(kSide, kSide);
        header.setName(name);
        header.setType(Imf::SCANLINEIMAGE);
        for (const char channel : channels)
            header.channels().insert(std::string(1, channel), Imf::Channel(Imf::FLOAT));
    }
    BytesStream stream;
    {
        Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()));
        for (size_t i = 0; i < headers.size(); ++i) {
            std::vector<float> samples(kSide * kSide, static_cast<float>(i + 1));
            Imf::FrameBuffer frame;
            for (auto c = headers[i].channels().begin(); c != headers[i].channels().end(); ++c)
                frame.insert(c.name(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()), sizeof(float),
                                                  kSide * sizeof(float)));
            Imf::OutputPart part(file, static_cast<int>(i));
            part.setFrameBuffer(frame);
            part.writePixels(kSide);
        }
    }  // the tables of offsets are written when the file is closed
    return stream.bytes;
}

Bytes MakeChromaExr(Size size, uint32_t channels,
                    const std::function<std::array<float, 4>(uint32_t x, uint32_t y)>& colorAt) {
    std::vector<Imf::Rgba> texels;
    for (uint32_t y = 0; y < size.height; ++y)
        for (uint32_t x = 0; x < size.width; ++x) {
            const std::array<float, 4> color = colorAt(x, y);
            texels.emplace_back(half(color[0]), half(color[1]), half(color[2]), half(color[3]));
        }
    BytesStream stream;
    {
        const Imf::Header header(static_cast<int>(size.width), static_cast<int>(size.height));
        Imf::RgbaOutputFile file(stream, header, channels == 4 ? Imf::WRITE_YCA : Imf::WRITE_YC);
        file.setFrameBuffer(texels.data(), 1, size.width);
        file.writePixels(static_cast<int>(size.height));
    }
    return stream.bytes;
}

Bytes MakeHdr(Size size, const std::vector<std::array<uint8_t, 4>>& texels, bool packed) {
    Bytes file = ToBytes(fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", size.height, size.width));
    for (uint32_t y = 0; y < size.height; ++y) {
        const auto* row = &texels[size_t{y} * size.width];
        if (!packed) {
            for (uint32_t x = 0; x < size.width; ++x)
                file.insert(file.end(), row[x].begin(), row[x].end());
            continue;
        }
        file.insert(file.end(),
                    {2, 2, static_cast<uint8_t>(size.width >> 8), static_cast<uint8_t>(size.width & 255)});
        for (size_t plane = 0; plane < 4; ++plane) {
            for (uint32_t x = 0; x < size.width;) {
                uint32_t end = x + 1;
                while (end < size.width && end - x < 127 && row[end][plane] == row[x][plane])
                    ++end;
                const uint32_t run = end - x;
                file.push_back(static_cast<uint8_t>(run > 1 ? 128 + run : 1));  // a run, or one sample as it stands
                file.push_back(row[x][plane]);
                x = end;
            }
        }
    }
    return file;
}

namespace {

Bytes TaggedPng(const Bytes& png) {
    Bytes file = WithChunk(png, {"eXIf", TiffOfOrientation(6, false)}, true);
    file = WithChunk(file, {"gAMA", {0, 1, 0x86, 0xa0}});
    return WithChunk(file, ProfileChunk(MakeProfile("RGB ")));
}

}  // namespace

std::vector<NamedFile> SmallFiles() {
    constexpr Size kSize = {12, 19};
    const auto codes = [&](size_t count) {
        Bytes bytes;
        for (uint32_t i = 0; i < count; ++i)
            bytes.push_back(static_cast<uint8_t>(i * 2654435761u >> 24));
        return bytes;
    };
    const auto pngCodes = [&](size_t samples) { return codes(samples * kSize.width * kSize.height); };
    const auto jpegCodes = [&](uint32_t channels) {
        Bytes bytes;
        for (const float sample : SmoothPicture(kSize, channels).samples)
            bytes.push_back(static_cast<uint8_t>(sample * 255.0f + 0.5f));
        return bytes;
    };
    std::vector<NamedFile> files = {
        {"grey8_png", MakePng(PngFile{kSize, PNG_COLOR_TYPE_GRAY, 8, pngCodes(1)})},
        {"grey2_png", MakePng(PngFile{kSize, PNG_COLOR_TYPE_GRAY, 2, codes(3 * 19)})},
        {"rgb8_png", MakePng(PngFile{kSize, PNG_COLOR_TYPE_RGB, 8, pngCodes(3)})},
        {"rgba16_png", MakePng(PngFile{kSize, PNG_COLOR_TYPE_RGB_ALPHA, 16, pngCodes(8)})},
        {"interlaced_png", MakePng(PngFile{kSize, PNG_COLOR_TYPE_RGB, 16, pngCodes(6), true})},
        {"palette4_png",
         MakePng(PngFile{kSize, PNG_COLOR_TYPE_PALETTE, 4, codes(6 * 19), false, codes(48), codes(3)})},
        {"tagged_png", TaggedPng(MakePng(PngFile{kSize, PNG_COLOR_TYPE_RGB, 8, pngCodes(3)}))},
        {"grey_jpg", MakeJpeg({kSize, 1, jpegCodes(1)})},
        {"colour_jpg", MakeJpeg({kSize, 3, jpegCodes(3)})},
        {"chroma420_jpg", MakeJpeg({kSize, 3, jpegCodes(3), false, 2})},
        {"progressive_jpg", MakeJpeg({kSize, 3, jpegCodes(3), true, 2})},
        {"cmyk_jpg", MakeJpeg({kSize, 4, jpegCodes(4)})},
        {"ycck_jpg", MakeJpeg({kSize, 4, jpegCodes(4), false, 1, false, JCS_YCCK})},
        {"arithmetic_jpg", MakeJpeg({kSize, 3, jpegCodes(3), false, 2, true})},
        {"arithmetic_progressive_jpg", MakeJpeg({kSize, 3, jpegCodes(3), true, 1, true})},
        {"profile_jpg", MakeJpeg({kSize, 1, jpegCodes(1), false, 1, false, 0, true, false, MakeProfile("GRAY")})},
        {"turned_jpg", WithOrientation(MakeJpeg({kSize, 3, jpegCodes(3)}), 6, true)},
        {"grey_pfm", ToBytes("Pf\n2 3\n-1.0\n" + std::string(24, 'x'))},
        {"colour_pfm", ToBytes("PF\n2 3\n1.0\n" + std::string(72, 'x'))},
    };
    std::vector<std::array<uint8_t, 4>> texels;
    for (uint32_t i = 0; i < kSize.width * kSize.height; ++i)
        texels.push_back(
            {static_cast<uint8_t>(128 + i % 100), static_cast<uint8_t>(i / 7), 9, static_cast<uint8_t>(120 + i % 9)});
    files.push_back({"packed_hdr", MakeHdr(kSize, texels, true)});
    files.push_back({"flat_hdr", MakeHdr({4, 57}, texels, false)});
    files.push_back({"old_hdr", ToBytes("#?RADIANCE\nEXPOSURE=2\n\n+X 3 -Y 5\n" + std::string("abcd\1\1\1\4", 8) +
                                        std::string("efgh\1\1\1\4", 8) + "ijklmnopqrstuvwxyzAB")});

    files.push_back({"parts_exr", MakePartsExr({{"depth", "Z"}, {"left", "RGB"}})});
    files.push_back({"chroma_exr", MakeChromaExr({8, 6}, 4, [](uint32_t x, uint32_t y) {
                         return std::array{0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y), 0.5f, 1.0f};
                     })});
    ExrFile framed{kSize, {{"Y", Imf::FLOAT, SmoothPicture(kSize, 1).samples}}, Imf::PIZ_COMPRESSION, 3, -5};
    framed.display = {0, 0, 20, 9};
    files.push_back({"framed_exr", MakeExr(framed)});
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression) {
        for (const bool tiled : {false, true}) {
            ExrFile exr{kSize, {}, compression, 3, -5, tiled};
            for (const char* name : {"R", "G", "B"})
                exr.channels.push_back({name, Imf::HALF, SmoothPicture(kSize, 1).samples});
            exr.channels.push_back({"A", Imf::FLOAT, SmoothPicture(kSize, 1).samples});
            files.push_back({fmt::format("{}{}_exr", tiled ? "tiles" : "lines", compression), MakeExr(exr)});
        }
    }
    return files;
}

void ExpectSame(const Picture& got, const Picture& expected) {
    EXPECT_EQ(got.widthTexels, expected.widthTexels);
    EXPECT_EQ(got.heightTexels, expected.heightTexels);
    EXPECT_EQ(got.channels, expected.channels);
    EXPECT_EQ(got.stored, expected.stored);
    EXPECT_EQ(got.samples, expected.samples);
}

}  // namespace boxcar::test
