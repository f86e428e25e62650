#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "samples/files/codecs.h"

namespace boxcar {
namespace {

constexpr const char* kEndOfFile = "unexpected end of file";

class MemoryReader : public Imf::IStream {
public:
    explicit MemoryReader(ByteView file) : IStream("EXR"), m_file(file) {}

    bool read(char* data, int bytes) override {
        // The library's own kind of exception: it goes on after this one where it can.
        if (bytes < 0 || m_at > m_file.size() || static_cast<uint64_t>(bytes) > m_file.size() - m_at)
            throw Iex::InputExc(kEndOfFile);
        std::memcpy(data, m_file.data() + m_at, static_cast<size_t>(bytes));
        m_at += static_cast<uint64_t>(bytes);
        return m_at < m_file.size();
    }
    uint64_t tellg() override { return m_at; }
    void seekg(uint64_t position) override { m_at = position; }

private:
    ByteView m_file;
    uint64_t m_at = 0;
};

class MemoryWriter : public Imf::OStream {
public:
    MemoryWriter() : OStream("EXR") {}

    void write(const char* data, int bytes) override {
        const size_t count = static_cast<size_t>(bytes);
        if (m_at + count > m_file.size()) m_file.resize(m_at + count);
        std::memcpy(m_file.data() + m_at, data, count);
        m_at += count;
    }
    uint64_t tellp() override { return m_at; }
    void seekp(uint64_t position) override { m_at = position; }

    Bytes Take() { return std::move(m_file); }

private:
    Bytes m_file;
    uint64_t m_at = 0;
};

int ReadVersion(MemoryReader& reader) {
    reader.seekg(4);
    uint8_t bytes[4];
    reader.read(reinterpret_cast<char*>(bytes), 4);
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16;
}

// The library takes the memory that an attribute's size asks for before it reads the attribute.
//
// OpenEXR file layout: magic (4 bytes), version (4), then name\0 type\0 size (4) value (size) until an empty name; in
// a file of several parts that once for each, until an empty header
void RequireAttributesWithin(ByteView file, bool isMultiPart) {
    size_t at = 8;
    const auto skipText = [&] {
        const auto end = std::find(file.begin() + static_cast<ptrdiff_t>(std::min(at, file.size())), file.end(), 0);
        if (end == file.end()) throw CutOff(FileFormat::Exr);
        const size_t begin = std::exchange(at, static_cast<size_t>(end - file.begin()) + 1);
        return at - begin - 1;
    };
    size_t attributes = 0;
    do {
        for (attributes = 0; skipText() > 0; ++attributes) {
            skipText();
            if (file.size() - at < 4) throw CutOff(FileFormat::Exr);
            const uint32_t size = uint32_t{file[at]} | uint32_t{file[at + 1]} << 8 | uint32_t{file[at + 2]} << 16 |
                                  uint32_t{file[at + 3]} << 24;
            at += 4;
            if (file.size() - at < size) throw CutOff(FileFormat::Exr);
            at += size;
        }
    } while (isMultiPart && attributes > 0);
}

struct Extent {
    uint64_t widthTexels;
    uint64_t heightTexels;
};

Extent ExtentOf(const Imath::Box2i& window) {
    return {static_cast<uint64_t>(std::max<int64_t>(int64_t{window.max.x} - window.min.x + 1, 0)),
            static_cast<uint64_t>(std::max<int64_t>(int64_t{window.max.y} - window.min.y + 1, 0))};
}

// The library takes memory for the table of a part's blocks before it reads the table, which is in the file.
uint64_t LeastTableBytes(const Imf::Header& header) {
    constexpr uint64_t kEntryBytes = 8;
    constexpr uint64_t kLines[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};  // in the order of Imf::Compression
    const Extent extent = ExtentOf(header.dataWindow());
    if (!header.hasTileDescription()) {
        const auto compression = static_cast<size_t>(header.compression());
        return extent.heightTexels / (compression < std::size(kLines) ? kLines[compression] : 256) * kEntryBytes;
    }
    const Imf::TileDescription& tile = header.tileDescription();
    return extent.widthTexels / std::max(tile.xSize, 1u) * (extent.heightTexels / std::max(tile.ySize, 1u)) *
           kEntryBytes;
}

// The headers alone: opening the file takes memory for the rows and tables that they ask for.
std::vector<Imf::Header> ReadHeaders(ByteView file, const PictureLimits& limits) {
    MemoryReader reader(file);
    int version = ReadVersion(reader);
    const bool isMultiPart = Imf::isMultiPart(version);
    RequireAttributesWithin(file, isMultiPart);
    std::vector<Imf::Header> headers;
    do {
        Imf::Header header;
        header.readFrom(reader, version);
        if (header.readsNothing()) break;
        headers.push_back(std::move(header));
    } while (isMultiPart);

    uint64_t tableBytes = 0;
    for (const Imf::Header& header : headers) {
        for (const Imath::Box2i& window : {header.dataWindow(), header.displayWindow()}) {
            const auto [width, height] = ExtentOf(window);
            RequireWithin(width, height, limits);
        }
        if (header.hasType() && !Imf::isSupportedType(header.type()))
            throw Error("an EXR part of the type {}; scan lines or tiles are expected", header.type());
        tableBytes += LeastTableBytes(header);
    }
    if (tableBytes > file.size()) throw CutOff(FileFormat::Exr);
    return headers;
}

// The library unpacks into blocks of all channels, whether they are read or not: tiles, or lines by the 256 at most.
void RequireBlocksWithin(const Imf::Header& header, const PictureLimits& limits) {
    double texels = static_cast<double>(ExtentOf(header.dataWindow()).widthTexels) * 256;
    if (header.hasTileDescription())
        texels = static_cast<double>(header.tileDescription().xSize) * header.tileDescription().ySize;
    double bytes = 0;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
        bytes += texels * (i.channel().type == Imf::HALF ? 2 : 4);
    const uint64_t allowed = MaxFileBytes(limits);
    if (bytes > static_cast<double>(allowed))
        throw Error("its tiles or groups of lines take {:.0f} MiB; at most {} MiB are allowed", bytes / (1 << 20),
                    allowed >> 20);
}

// What of a part is read.
struct Selection {
    std::vector<std::string> channels;  // empty where nothing of it can be read
    bool isLuminanceChroma = false;
};

Selection Select(const Imf::Header& header) {
    if (header.hasType() && Imf::isDeepData(header.type())) return {};
    const Imf::ChannelList& channels = header.channels();
    const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
    Selection selection;
    if (has("R") && has("G") && has("B")) {
        selection.channels = {"R", "G", "B"};
    } else if (has("Y") && has("RY") && has("BY")) {
        selection = {{"R", "G", "B"}, true};
    } else if (has("Y") && !has("RY") && !has("BY")) {
        selection.channels = {"Y"};
    } else if (channels.begin() != channels.end() && ++channels.begin() == channels.end()) {
        return {{channels.begin().name()}, false};
    }
    if (!selection.channels.empty() && has("A")) selection.channels.push_back("A");
    return selection;
}

std::string PartName(const std::vector<Imf::Header>& headers, size_t part) {
    return headers[part].hasName() ? headers[part].name() : fmt::format("{}", part);
}

[[noreturn]] void ThrowNothingToRead(const std::vector<Imf::Header>& headers) {
    std::string found;
    bool isDeep = true;
    for (const Imf::Header& header : headers) {
        const Imf::ChannelList& channels = header.channels();
        for (auto i = channels.begin(); i != channels.end() && found.size() < 80; ++i)
            found += fmt::format(" {}", i.name());
        isDeep = isDeep && header.hasType() && Imf::isDeepData(header.type());
    }
    if (isDeep) throw Error("an EXR of deep pixels; flat ones are expected");
    if (found.empty()) found = " none";
    throw Error("its channels are{}; R G B [A], Y [A], Y RY BY [A] or a single one are expected", found);
}

// The part to read. Parts with color or luminance come before those with a single channel of another name, such as a
// depth.
size_t ChoosePart(const std::vector<Imf::Header>& headers, std::vector<std::string>& notes) {
    const auto isPicture = [](const Imf::Header& header) {
        const std::vector<std::string> channels = Select(header).channels;
        return !channels.empty() && (channels[0] == "R" || channels[0] == "Y");
    };
    auto chosen = std::ranges::find_if(headers, isPicture);
    if (chosen == headers.end())
        chosen = std::ranges::find_if(headers, [](const auto& header) { return !Select(header).channels.empty(); });
    if (chosen == headers.end()) ThrowNothingToRead(headers);
    const auto part = static_cast<size_t>(chosen - headers.begin());
    std::string others;
    for (size_t i = 0; i < headers.size() && others.size() < 80; ++i)
        if (i != part) others += fmt::format("{} {}", others.empty() ? "" : ",", PartName(headers, i));
    if (!others.empty())
        notes.push_back(fmt::format("part {} is read and the others are not:{}", PartName(headers, part), others));
    return part;
}

// Both read the rows from `first` to `last`, whole, into `samples`.
void ReadChannels(MemoryReader& reader, int part, const Selection& selection, const Imath::Box2i& rows,
                  float* samples) {
    Imf::MultiPartInputFile file(reader);
    Imf::InputPart input(file, part);
    const size_t texelBytes = selection.channels.size() * sizeof(float);
    const size_t rowBytes = texelBytes * ExtentOf(rows).widthTexels;
    Imf::FrameBuffer frame;
    for (const std::string& name : selection.channels)
        frame.insert(name, Imf::Slice::Make(Imf::FLOAT, samples++, rows, texelBytes, rowBytes));
    input.setFrameBuffer(frame);
    input.readPixels(rows.min.y, rows.max.y);
}

void ReadLuminanceChroma(MemoryReader& reader, bool hasAlpha, const Imath::Box2i& rows, float* samples) {
    Imf::RgbaInputFile input(reader);
    const size_t width = ExtentOf(rows).widthTexels;
    std::vector<Imf::Rgba> row(width);
    for (int y = rows.min.y; y <= rows.max.y; ++y) {
        input.setFrameBuffer(row.data() - rows.min.x, 1, 0);
        input.readPixels(y);
        for (const Imf::Rgba& texel : row) {
            for (const half value : {texel.r, texel.g, texel.b})
                *samples++ = value;
            if (hasAlpha) *samples++ = texel.a;
        }
    }
}

// The picture that is seen through the display window, of one whose texels lie in the rows `data`.
Picture ThroughDisplayWindow(Picture picture, const Imath::Box2i& data, const Imath::Box2i& display) {
    if (data == display) return picture;
    const Extent extent = ExtentOf(display);
    Picture seen = MakePicture(extent.widthTexels, extent.heightTexels, picture.channels, SampleType::Float32);
    const int64_t left = std::max(data.min.x, display.min.x), right = std::min(data.max.x, display.max.x);
    for (int64_t y = data.min.y; y <= data.max.y; ++y) {
        const int64_t from = (y - data.min.y) * picture.widthTexels + left - data.min.x;
        const int64_t to = (y - display.min.y) * seen.widthTexels + left - display.min.x;
        std::copy_n(picture.samples.begin() + from * picture.channels, (right - left + 1) * picture.channels,
                    seen.samples.begin() + to * picture.channels);
    }
    return seen;
}

Picture Decode(ByteView file, const PictureLimits& limits) {
    const std::vector<Imf::Header> headers = ReadHeaders(file, limits);
    std::vector<std::string> notes;
    const size_t part = ChoosePart(headers, notes);
    const Imf::Header& header = headers[part];
    const Selection selection = Select(header);
    RequireBlocksWithin(header, limits);
    if (selection.isLuminanceChroma && part > 0)
        throw Error("luminance and chroma in part {}; they are read from the first part", PartName(headers, part));
    if (!selection.isLuminanceChroma)
        for (const std::string& name : selection.channels) {
            const Imf::Channel& channel = header.channels()[name];
            if (channel.xSampling != 1 || channel.ySampling != 1)
                throw Error("its channel {} is subsampled; one sample a texel is expected", name);
        }

    const Imath::Box2i window = header.dataWindow(), display = header.displayWindow();
    if (!window.intersects(display))
        throw Error(
            "its texels, ({}, {}) to ({}, {}), are all outside its display window, ({}, {}) to ({}, {}); some "
            "are expected within",
            window.min.x, window.min.y, window.max.x, window.max.y, display.min.x, display.min.y, display.max.x,
            display.max.y);
    Imath::Box2i rows = window;
    rows.min.y = std::max(rows.min.y, display.min.y);
    rows.max.y = std::min(rows.max.y, display.max.y);
    const auto [width, height] = ExtentOf(rows);
    Picture picture =
        MakePicture(width, height, static_cast<uint32_t>(selection.channels.size()), SampleType::Float32);
    MemoryReader reader(file);
    if (selection.isLuminanceChroma)
        ReadLuminanceChroma(reader, HasAlpha(picture), rows, picture.samples.data());
    else
        ReadChannels(reader, static_cast<int>(part), selection, rows, picture.samples.data());
    picture = ThroughDisplayWindow(std::move(picture), rows, display);

    picture.notes = std::move(notes);
    if (window.min.x < display.min.x || window.max.x > display.max.x || window.min.y < display.min.y ||
        window.max.y > display.max.y)
        picture.notes.push_back(
            fmt::format("its texels outside the display window are left out: data ({}, {}) to ({}, {}), display ({}, "
                        "{}) to ({}, {})",
                        window.min.x, window.min.y, window.max.x, window.max.y, display.min.x, display.min.y,
                        display.max.x, display.max.y));
    if (Imf::hasChromaticities(header)) {
        const Imf::Chromaticities& c = Imf::chromaticities(header);
        SetPrimaries(picture, {c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y});
    }
    return picture;
}

}  // namespace

Picture DecodeExr(ByteView file, const PictureLimits& limits) {
    try {
        return Decode(file, limits);
    } catch (const Iex::BaseExc& error) {
        if (std::string_view(error.what()).find(kEndOfFile) != std::string_view::npos) throw CutOff(FileFormat::Exr);
        throw Error("damaged or cut off EXR ({})", error.what());
    }
}

namespace {

Bytes Encode(const Imf::Header& header, const Imf::FrameBuffer& frame) {
    MemoryWriter writer;
    {
        Imf::OutputFile output(writer, header);
        output.setFrameBuffer(frame);
        output.writePixels(header.dataWindow().max.y + 1);
    }  // the table of offsets is written when the file is closed
    return writer.Take();
}

Imf::Header ZipHeader(uint32_t widthTexels, uint32_t heightTexels) {
    Imf::Header header(static_cast<int>(widthTexels), static_cast<int>(heightTexels));
    header.compression() = Imf::ZIP_COMPRESSION;
    return header;
}

}  // namespace

Bytes EncodeExr(const Picture& picture) {
    const std::string_view names = picture.channels <= 2 ? "YA" : "RGBA";
    Imf::Header header = ZipHeader(picture.widthTexels, picture.heightTexels);
    const size_t texelBytes = picture.channels * sizeof(float);
    Imf::FrameBuffer frame;
    for (size_t i = 0; i < picture.channels; ++i) {
        const std::string name(1, names[i]);
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, Imf::Slice::Make(Imf::FLOAT, &picture.samples[i], header.dataWindow(), texelBytes,
                                            texelBytes * picture.widthTexels));
    }
    if (const auto& p = picture.colorSpace.primaries)
        Imf::addChromaticities(header, Imf::Chromaticities({(*p)[0], (*p)[1]}, {(*p)[2], (*p)[3]}, {(*p)[4], (*p)[5]},
                                                           {(*p)[6], (*p)[7]}));
    return Encode(header, frame);
}

void WriteUintExr(const std::vector<UintChannel>& channels, uint32_t widthTexels, uint32_t heightTexels,
                  const std::string& path) {
    Imf::Header header = ZipHeader(widthTexels, heightTexels);
    Imf::FrameBuffer frame;
    for (const UintChannel& channel : channels) {
        BOXCAR_ASSERT(channel.samples.size() == size_t{widthTexels} * heightTexels);
        header.channels().insert(channel.name, Imf::Channel(Imf::UINT));
        frame.insert(channel.name, Imf::Slice::Make(Imf::UINT, channel.samples.data(), header.dataWindow(),
                                                    sizeof(uint32_t), sizeof(uint32_t) * widthTexels));
    }
    WriteFileAtomically(path, Encode(header, frame));
}

}  // namespace boxcar
