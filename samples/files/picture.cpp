#include "samples/files/picture.h"

#include <algorithm>
#include <array>
#include <new>

#include "samples/files/bytes.h"
#include "samples/files/codecs.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint64_t kMiB = uint64_t{1} << 20;
constexpr uint64_t kTexelBytes = 16;  // of RGBA32F

struct Ending {
    std::string_view word;
    FileFormat format;
};
constexpr std::array<Ending, 6> kEndings = {{{"png", FileFormat::Png},
                                             {"jpg", FileFormat::Jpeg},
                                             {"jpeg", FileFormat::Jpeg},
                                             {"hdr", FileFormat::Hdr},
                                             {"exr", FileFormat::Exr},
                                             {"pfm", FileFormat::Pfm}}};

std::optional<FileFormat> FindFormat(std::string word) {
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const auto found =
        std::find_if(kEndings.begin(), kEndings.end(), [&](const Ending& e) { return e.word == word; });
    return found == kEndings.end() ? std::nullopt : std::optional(found->format);
}

FileFormat FormatFromContent(ByteView start) {
    if (start.empty()) throw Error("the file is empty; a PNG, JPEG, HDR, EXR or PFM picture is expected");
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    if (text.starts_with("\x89PNG\r\n\x1a\n")) return FileFormat::Png;
    if (text.starts_with("\xff\xd8\xff")) return FileFormat::Jpeg;
    if (text.starts_with("#?RADIANCE") || text.starts_with("#?RGBE")) return FileFormat::Hdr;
    if (text.starts_with("\x76\x2f\x31\x01")) return FileFormat::Exr;
    for (const std::string_view magic : {"PF\n", "Pf\n", "PF ", "Pf ", "PF\r", "Pf\r"})
        if (text.starts_with(magic)) return FileFormat::Pfm;
    throw Error("no picture that is known; PNG, JPEG, HDR, EXR or PFM is expected");
}

Picture Decode(ByteView file, FileFormat format, const PictureLimits& limits) {
    switch (format) {
        case FileFormat::Png: return DecodePng(file, limits);
        case FileFormat::Jpeg: return DecodeJpeg(file, limits);
        case FileFormat::Hdr: return DecodeHdr(file, limits);
        case FileFormat::Exr: return DecodeExr(file, limits);
        case FileFormat::Pfm: break;
    }
    return DecodePfm(file, limits);
}

Bytes Encode(const Picture& picture, FileFormat format, SampleType sampleType) {
    switch (format) {
        case FileFormat::Png: return EncodePng(picture, sampleType);
        case FileFormat::Jpeg: return EncodeJpeg(picture);
        case FileFormat::Exr: return EncodeExr(picture);
        default: return EncodePfm(picture);
    }
}

// Does `work`; its errors get the name in front.
template <typename Work>
auto WithName(const std::string& name, Work work) {
    try {
        return work();
    } catch (const Error& error) {
        throw Error("{}: {}", name, error.what());
    } catch (const std::bad_alloc&) {
        throw Error("{}: there is not enough memory for it", name);
    }
}

}  // namespace

bool HasAlpha(const Picture& picture) {
    return picture.channels % 2 == 0;
}

std::string_view FormatName(FileFormat format) {
    constexpr std::string_view kNames[] = {"PNG", "JPEG", "HDR", "EXR", "PFM"};
    return kNames[static_cast<size_t>(format)];
}

FileFormat FormatFromName(const std::string& path) {
    const size_t dot = path.rfind('.');
    if (const auto format = FindFormat(dot == std::string::npos ? "" : path.substr(dot + 1))) return *format;
    throw Error("{}: the name says no format; an ending .png, .jpg, .jpeg, .exr or .pfm is expected", path);
}

FileFormat FormatFromWord(const std::string& word) {
    if (const auto format = FindFormat(word)) return *format;
    throw Error("{}: no format; png, jpg, jpeg, hdr, exr or pfm is expected", word);
}

void RequireWithin(uint64_t widthTexels, uint64_t heightTexels, const PictureLimits& limits) {
    if (widthTexels == 0 || heightTexels == 0)
        throw Error("{} x {} texels; a side must be at least 1", widthTexels, heightTexels);
    if (std::max(widthTexels, heightTexels) > limits.maxSideTexels)
        throw Error("{} x {} texels; a side may be at most {}", widthTexels, heightTexels, limits.maxSideTexels);
    const uint64_t texels = widthTexels * heightTexels;
    if (texels > limits.maxBytes / kTexelBytes)
        throw Error("{} x {} texels need {} MiB as RGBA32F; at most {} MiB are allowed", widthTexels, heightTexels,
                    (texels + kMiB / kTexelBytes - 1) / (kMiB / kTexelBytes), limits.maxBytes / kMiB);
}

uint64_t MaxFileBytes(const PictureLimits& limits) {
    return std::max(limits.maxBytes, limits.maxBytes + 64 * kMiB);  // the sum may wrap
}

Error CutOff(FileFormat format) {
    return Error("cut off: the {} ends before its picture does", FormatName(format));
}

Error Unreadable(FileFormat format, std::string_view reason) {
    return Error("damaged {0}, or a kind of {0} that is not read ({1})", FormatName(format), reason);
}

const std::array<float, 256>& SamplesOf8Bits() {
    static const std::array<float, 256> samples = [] {
        std::array<float, 256> table;
        for (size_t code = 0; code < table.size(); ++code)
            table[code] = static_cast<float>(code) / 255.0f;
        return table;
    }();
    return samples;
}

Picture MakePicture(uint64_t widthTexels, uint64_t heightTexels, uint32_t channels, SampleType stored) {
    return {static_cast<uint32_t>(widthTexels), static_cast<uint32_t>(heightTexels), channels, stored,
            std::vector<float>(widthTexels * heightTexels * channels)};
}

Picture ReadPicture(const std::string& path, const PictureLimits& limits, std::optional<FileFormat> format) {
    const std::string name = InputName(path);
    const auto checkStart = [&](ByteView start) {
        WithName(name, [&] {
            const FileFormat content = FormatFromContent(start);
            if (format && *format != content)
                throw Error("{} inside; {} is expected", FormatName(content), FormatName(*format));
        });
    };
    const Bytes file = ReadBytes(path, MaxFileBytes(limits), checkStart);
    return DecodePicture(file, name, limits);
}

Picture DecodePicture(std::span<const uint8_t> file, const std::string& name, const PictureLimits& limits) {
    constexpr size_t kMostNotes = 8, kMostNoteChars = 200;
    Picture picture = WithName(name, [&] { return Decode(file, FormatFromContent(file), limits); });
    picture.notes.resize(std::min(picture.notes.size(), kMostNotes));
    for (std::string& note : picture.notes)
        note = Printable(note.substr(0, kMostNoteChars));
    return picture;
}

SampleType SampleTypeFor(FileFormat format, SampleType stored) {
    if (format == FileFormat::Png) return stored == SampleType::Unorm16 ? SampleType::Unorm16 : SampleType::Unorm8;
    return format == FileFormat::Jpeg ? SampleType::Unorm8 : SampleType::Float32;
}

void RequireWritable(const std::string& path, FileFormat format, uint32_t channels) {
    const std::string name = OutputName(path);
    if (format == FileFormat::Hdr) throw Error("{}: HDR is read, not written; .exr or .pfm holds the same", name);
    if (channels % 2 != 0) return;
    if (format == FileFormat::Jpeg) throw Error("{}: JPEG holds no alpha; PNG and EXR do", name);
    if (format == FileFormat::Pfm) throw Error("{}: PFM holds no alpha; EXR does", name);
}

void WritePicture(const Picture& picture, const std::string& path, FileFormat format, SampleType sampleType) {
    BOXCAR_ASSERT(picture.channels >= 1 && picture.channels <= 4);
    BOXCAR_ASSERT(picture.samples.size() == uint64_t{picture.widthTexels} * picture.heightTexels * picture.channels);
    BOXCAR_ASSERT(!picture.samples.empty());
    RequireWritable(path, format, picture.channels);
    BOXCAR_ASSERT(SampleTypeFor(format, sampleType) == sampleType);
    WriteFileAtomically(path, WithName(OutputName(path), [&] { return Encode(picture, format, sampleType); }));
}

}  // namespace boxcar
