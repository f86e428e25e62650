#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "samples/files/codecs.h"

namespace boxcar {
namespace {

class MemoryReader : public Imf::IStream {
public:
    explicit MemoryReader(ByteView file) : IStream("EXR"), m_file(file) {}

    bool read(char* data, int bytes) override {
        // The library's own kind of exception: it goes on after this one where it can.
        if (bytes < 0 || m_at > m_file.size() || static_cast<uint64_t>(bytes) > m_file.size() - m_at)
            throw Iex::InputExc("unexpected end of file");
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

// The library takes the memory that an attribute's size asks for before it reads the attribute.
//
// OpenEXR file layout: magic (4 bytes), version (4), then name\0 type\0 size (4) value (size) until an empty name
void RequireAttributesWithin(ByteView file) {
    size_t at = 8;
    const auto skipText = [&] {
        const auto end = std::find(file.begin() + static_cast<ptrdiff_t>(std::min(at, file.size())), file.end(), 0);
        if (end == file.end()) throw CutOff(FileFormat::Exr);
        const size_t begin = std::exchange(at, static_cast<size_t>(end - file.begin()) + 1);
        return at - begin - 1;
    };
    while (skipText() > 0) {
        skipText();
        if (file.size() - at < 4) throw CutOff(FileFormat::Exr);
        const uint32_t size = uint32_t{file[at]} | uint32_t{file[at + 1]} << 8 | uint32_t{file[at + 2]} << 16 |
                              uint32_t{file[at + 3]} << 24;
        at += 4;
        if (file.size() - at < size) throw CutOff(FileFormat::Exr);
        at += size;
    }
}

// The library unpacks into blocks of all channels, whether they are read or not: tiles, or lines by the 256 at most.
void RequireBlocksWithin(const Imf::Header& header, uint64_t widthTexels, const PictureLimits& limits) {
    double texels = static_cast<double>(widthTexels) * 256;
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

std::vector<std::string> ChannelsToRead(const Imf::ChannelList& channels) {
    const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
    std::vector<std::string> names;
    if (has("R") && has("G") && has("B")) {
        names = {"R", "G", "B"};
    } else if (has("Y") && !has("RY") && !has("BY")) {
        names = {"Y"};
    } else if (channels.begin() != channels.end() && ++channels.begin() == channels.end()) {
        return {channels.begin().name()};
    } else {
        std::string found;
        for (auto i = channels.begin(); i != channels.end() && found.size() < 80; ++i)
            found += fmt::format(" {}", i.name());
        if (found.empty()) found = " none";
        throw Error("its channels are{}; R G B [A], Y [A] or a single one are expected", found);
    }
    if (has("A")) names.push_back("A");
    return names;
}

Picture Decode(ByteView file, const PictureLimits& limits) {
    RequireAttributesWithin(file);

    // The header alone first: opening the file takes memory for its rows.
    MemoryReader reader(file);
    reader.seekg(4);
    uint8_t versionBytes[4];
    reader.read(reinterpret_cast<char*>(versionBytes), 4);
    int version = versionBytes[0] | versionBytes[1] << 8 | versionBytes[2] << 16;
    if (Imf::isMultiPart(version) || Imf::isNonImage(version))
        throw Error("an EXR of several parts or of deep pixels; a single flat part is expected");
    Imf::Header header;
    header.readFrom(reader, version);
    const Imath::Box2i window = header.dataWindow();
    const int64_t width = int64_t{window.max.x} - window.min.x + 1;
    const int64_t height = int64_t{window.max.y} - window.min.y + 1;
    RequireWithin(static_cast<uint64_t>(std::max<int64_t>(width, 0)),
                  static_cast<uint64_t>(std::max<int64_t>(height, 0)), limits);
    RequireBlocksWithin(header, static_cast<uint64_t>(width), limits);

    const std::vector<std::string> names = ChannelsToRead(header.channels());
    for (const std::string& name : names) {
        const Imf::Channel& channel = header.channels()[name];
        if (channel.xSampling != 1 || channel.ySampling != 1)
            throw Error("its channel {} is subsampled; one sample a texel is expected", name);
    }

    reader.seekg(0);
    Imf::InputFile input(reader);
    Picture picture = MakePicture(static_cast<uint64_t>(width), static_cast<uint64_t>(height),
                                  static_cast<uint32_t>(names.size()), SampleType::Float32);
    const size_t texelBytes = names.size() * sizeof(float);
    Imf::FrameBuffer frame;
    for (size_t i = 0; i < names.size(); ++i)
        frame.insert(names[i], Imf::Slice::Make(Imf::FLOAT, &picture.samples[i], window, texelBytes,
                                                texelBytes * static_cast<size_t>(width)));
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
    return picture;
}

}  // namespace

Picture DecodeExr(ByteView file, const PictureLimits& limits) {
    try {
        return Decode(file, limits);
    } catch (const Iex::BaseExc& error) {
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
