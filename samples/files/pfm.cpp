// Debevec's portable float map: "PF" (color) or "Pf" (gray), width, height, a scale whose sign is the byte order;
// then rows of float32, bottom row first.
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "samples/files/codecs.h"

namespace boxcar {
namespace {

constexpr bool IsSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// Takes the next word off `text`. Empty at its end.
std::string_view NextWord(std::string_view& text) {
    const auto begin = std::find_if_not(text.begin(), text.end(), IsSpace);
    const auto end = std::find_if(begin, text.end(), IsSpace);
    text.remove_prefix(static_cast<size_t>(end - text.begin()));
    return {begin, end};
}

// Takes a number off `text`; `name` and `expected` are for messages.
template <typename Number>
Number NextNumber(std::string_view& text, std::string_view name, std::string_view expected) {
    constexpr size_t kMostChars = 40;
    const std::string_view word = NextWord(text);
    if (word.empty()) throw CutOff(FileFormat::Pfm);
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    Number number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (end != digits.data() + digits.size() || error == std::errc::invalid_argument)
        throw Error("damaged PFM: {} {}; {} is expected", name, word.substr(0, kMostChars), expected);
    return error == std::errc() ? number : std::numeric_limits<Number>::max();
}

// How many characters lie between the scale and the floats, at the start of `text`. One, by the format; some programs
// write spaces and CR LF there. Floats may begin with bytes that look like either, so the length of the file is asked
// first; one that has more after its picture is taken to end its header with the first line end.
size_t SeparatorChars(std::string_view text, uint64_t floatBytes) {
    size_t spaces = 0;
    while (spaces < text.size() && IsSpace(text[spaces]) && text[spaces] != '\n')
        ++spaces;
    const bool hasLineEnd = spaces < text.size() && text[spaces] == '\n';
    const size_t most = spaces + (hasLineEnd ? 1 : 0);
    if (text.size() > floatBytes && text.size() - floatBytes <= most) return text.size() - floatBytes;
    return hasLineEnd ? most : 1;
}

uint32_t LoadWord(const uint8_t* bytes, bool littleEndian) {
    const uint32_t word =
        uint32_t{bytes[0]} | uint32_t{bytes[1]} << 8 | uint32_t{bytes[2]} << 16 | uint32_t{bytes[3]} << 24;
    return littleEndian ? word : __builtin_bswap32(word);
}

}  // namespace

Picture DecodePfm(ByteView file, const PictureLimits& limits) {
    std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    const uint32_t channels = NextWord(text) == "PF" ? 3 : 1;
    constexpr std::string_view kSide = "a whole number above 0";
    const auto width = NextNumber<uint64_t>(text, "width", kSide);
    const auto height = NextNumber<uint64_t>(text, "height", kSide);
    const auto scale = NextNumber<double>(text, "scale", "a number not 0");
    if (scale == 0.0 || !std::isfinite(scale))
        throw Error("damaged PFM: scale {}; a number not 0 is expected", scale);
    RequireWithin(width, height, limits);

    const size_t rowSamples = width * channels;
    const uint64_t floatBytes = height * rowSamples * 4;
    const size_t separator = SeparatorChars(text, floatBytes);
    if (text.size() < separator + floatBytes) throw CutOff(FileFormat::Pfm);
    const uint8_t* from = file.data() + (file.size() - text.size()) + separator;

    Picture picture = MakePicture(width, height, channels, SampleType::Float32);
    for (size_t y = height; y-- > 0;) {
        for (size_t i = 0; i < rowSamples; ++i, from += 4)
            picture.samples[y * rowSamples + i] = std::bit_cast<float>(LoadWord(from, scale < 0.0));
    }
    return picture;
}

Bytes EncodePfm(const Picture& picture) {
    const std::string header = fmt::format("{}\n{} {}\n-1.0\n", picture.channels == 3 ? "PF" : "Pf",
                                           picture.widthTexels, picture.heightTexels);
    Bytes file(header.begin(), header.end());
    file.reserve(header.size() + picture.samples.size() * 4);
    const size_t rowSamples = size_t{picture.widthTexels} * picture.channels;
    for (size_t y = picture.heightTexels; y-- > 0;) {
        for (size_t i = 0; i < rowSamples; ++i) {
            const auto word = std::bit_cast<uint32_t>(picture.samples[y * rowSamples + i]);
            for (int shift = 0; shift < 32; shift += 8)
                file.push_back(static_cast<uint8_t>(word >> shift & 255));
        }
    }
    return file;
}

}  // namespace boxcar
