#include <charconv>
#include <limits>
#include <string_view>

#include "samples/files/codecs.h"
#include "samples/files/stb.h"

namespace boxcar {
namespace {

std::string_view NextLine(std::string_view& text) {
    const size_t end = text.find('\n');
    if (end == std::string_view::npos) throw CutOff(FileFormat::Hdr);
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    return line;
}

// Takes "NAME NUMBER" off `line`, and the space after it.
uint64_t NextSide(std::string_view& line, std::string_view name) {
    uint64_t side = 0;
    if (line.starts_with(name)) {
        line.remove_prefix(name.size());
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), side);
        if (error == std::errc::result_out_of_range) side = std::numeric_limits<uint64_t>::max();
        if (error != std::errc::invalid_argument) {
            line.remove_prefix(static_cast<size_t>(end - line.data()));
            if (line.starts_with(' ')) line.remove_prefix(1);
            return side;
        }
    }
    throw Error("an HDR whose rows do not run from the top left; -Y HEIGHT +X WIDTH is expected in its header");
}

}  // namespace

// Radiance file formats (Ward): "#?RADIANCE", lines of variables, an empty line, the sides; then RGBE texels
Picture DecodeHdr(ByteView file, const PictureLimits& limits) {
    std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    while (!NextLine(text).empty()) {
    }
    std::string_view sides = NextLine(text);
    const uint64_t height = NextSide(sides, "-Y ");
    const uint64_t width = NextSide(sides, "+X ");
    RequireWithin(width, height, limits);
    return DecodeWithStb(file, FileFormat::Hdr, SampleType::Float32, width, height);
}

}  // namespace boxcar
