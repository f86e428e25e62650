// Radiance's pictures (Ward, "Radiance file formats"): "#?RADIANCE", lines of variables, an empty line, the sides as
// in "-Y HEIGHT +X WIDTH"; then rows of RGBE texels, each flat or in one of two run-length codings.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "samples/files/codecs.h"
#include "samples/files/orientation.h"

namespace boxcar {
namespace {

using Texel = std::array<uint8_t, 4>;  // mantissas of red, green and blue, and their exponent

std::string_view NextLine(std::string_view& text) {
    const size_t end = text.find('\n');
    if (end == std::string_view::npos) throw CutOff(FileFormat::Hdr);
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

// The numbers at the start of `text`, apart by spaces.
std::vector<float> Numbers(std::string_view text) {
    std::vector<float> numbers;
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t+"), text.size()));
        float number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc()) return numbers;
        numbers.push_back(number);
        text.remove_prefix(static_cast<size_t>(end - text.data()));
    }
}

void ReadVariable(std::string_view line, Picture& picture, double& exposure) {
    const auto valueOf = [&](std::string_view name) {
        return line.starts_with(name) ? line.substr(name.size()) : std::string_view();
    };
    const auto isOne = [](float number) { return number == 1.0f; };
    if (const auto format = valueOf("FORMAT="); !format.empty() && format != "32-bit_rle_rgbe")
        throw Error("an HDR of {}; 32-bit_rle_rgbe is expected",
                    format == "32-bit_rle_xyze" ? "XYZ colors (32-bit_rle_xyze)" : format);
    for (const float factor : Numbers(valueOf("EXPOSURE=")))
        exposure *= factor;
    for (const std::string_view name : {"COLORCORR", "GAMMA", "PIXASPECT"}) {
        const std::string_view text = valueOf(name);
        const std::vector<float> numbers = Numbers(text.substr(std::min<size_t>(1, text.size())));
        if (text.starts_with('=') && !std::ranges::all_of(numbers, isOne))
            picture.notes.push_back(
                fmt::format("its {}{} is not used: values are as the file holds them", name, text));
    }
    if (const std::vector<float> numbers = Numbers(valueOf("PRIMARIES=")); numbers.size() == 8) {
        Primaries primaries;
        std::ranges::copy(numbers, primaries.begin());
        SetPrimaries(picture, primaries);
    }
}

struct Sides {
    uint64_t rows = 0;
    uint64_t columns = 0;
    int orientation = 1;  // as EXIF counts them
};

// "-Y" and the like, a space, a number; taken off `line`. The first is the axis from row to row.
uint64_t NextSide(std::string_view& line, std::string& axes) {
    uint64_t side = 0;
    axes += line.substr(0, 2);
    line.remove_prefix(std::min<size_t>(line.size(), 3));
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), side);
    if (error == std::errc::result_out_of_range) side = std::numeric_limits<uint64_t>::max();
    if (error == std::errc::invalid_argument) axes += '?';
    line.remove_prefix(static_cast<size_t>(end - line.data()));
    if (line.starts_with(' ')) line.remove_prefix(1);
    return side;
}

Sides ReadSides(std::string_view line) {
    constexpr std::string_view kAxes[] = {"-Y+X", "-Y-X", "+Y-X", "+Y+X", "+X-Y", "-X-Y", "-X+Y", "+X+Y"};
    std::string axes;
    std::string_view rest = line;
    Sides sides;
    sides.rows = NextSide(rest, axes);
    sides.columns = NextSide(rest, axes);
    const auto found = std::ranges::find(kAxes, axes);
    if (found == std::end(kAxes))
        throw Error("damaged HDR: {:?} for its sides; -Y HEIGHT +X WIDTH is expected, or another order of the axes",
                    line.substr(0, 80));
    sides.orientation = static_cast<int>(found - kAxes) + 1;
    return sides;
}

class RowReader {
public:
    explicit RowReader(std::string_view text) : m_text(text) {}

    void Read(std::span<Texel> row) {
        constexpr size_t kLeastPacked = 8, kMostPacked = 0x7fff;
        const Texel start = Peek();
        if (start[0] == 2 && start[1] == 2 && start[2] < 128 && row.size() >= kLeastPacked &&
            row.size() <= kMostPacked) {
            if (size_t{start[2]} << 8 != (row.size() & 0x7f00) || start[3] != (row.size() & 255))
                throw Error("damaged HDR: a row of {} texels in a picture of {}", start[2] << 8 | start[3],
                            row.size());
            m_text.remove_prefix(4);
            for (size_t plane = 0; plane < 4; ++plane)
                ReadPlane(row, plane);
        } else {
            ReadTexels(row);
        }
    }

private:
    // A count above 128 is that of a run, less 128; another that of bytes as they are.
    void ReadPlane(std::span<Texel> row, size_t plane) {
        for (size_t x = 0; x < row.size();) {
            const uint8_t code = Next();
            const size_t count = code > 128 ? code - 128 : code;
            if (count == 0 || count > row.size() - x) throw Error("damaged HDR: a run beyond the end of its row");
            uint8_t value = 0;
            for (size_t i = 0; i < count; ++i) {
                if (i == 0 || code <= 128) value = Next();
                row[x++][plane] = value;
            }
        }
    }

    // Mantissas of 1 1 1 repeat the texel before them; runs one after another are the bytes of one count, lowest
    // first.
    void ReadTexels(std::span<Texel> row) {
        int shift = 0;
        for (size_t x = 0; x < row.size();) {
            const Texel texel = Peek();
            m_text.remove_prefix(4);
            if (texel[0] != 1 || texel[1] != 1 || texel[2] != 1) {
                row[x++] = texel;
                shift = 0;
                continue;
            }
            const uint64_t count = uint64_t{texel[3]} << shift;
            if (x == 0 || shift > 24 || count > row.size() - x)
                throw Error("damaged HDR: a run beyond the ends of its row");
            std::fill_n(row.begin() + static_cast<ptrdiff_t>(x), count, row[x - 1]);
            x += count;
            shift += 8;
        }
    }

    uint8_t Next() {
        if (m_text.empty()) throw CutOff(FileFormat::Hdr);
        const auto byte = static_cast<uint8_t>(m_text[0]);
        m_text.remove_prefix(1);
        return byte;
    }

    Texel Peek() const {
        if (m_text.size() < 4) throw CutOff(FileFormat::Hdr);
        Texel texel;
        std::copy_n(m_text.begin(), 4, texel.begin());
        return texel;
    }

    std::string_view m_text;
};

}  // namespace

Picture DecodeHdr(ByteView file, const PictureLimits& limits) {
    std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    Picture header = MakePicture(0, 0, 3, SampleType::Float32);
    double exposure = 1;
    for (std::string_view line = NextLine(text); !line.empty(); line = NextLine(text))
        ReadVariable(line, header, exposure);
    if (exposure != 1)
        header.notes.push_back(
            fmt::format("its EXPOSURE of {:g} is not divided out: values are as the file holds them", exposure));
    const Sides sides = ReadSides(NextLine(text));
    RequireWithin(sides.columns, sides.rows, limits);
    if (text.size() < 4 * sides.rows) throw CutOff(FileFormat::Hdr);  // the least that a row takes

    Picture picture = MakePicture(sides.columns, sides.rows, 3, SampleType::Float32);
    picture.colorSpace = header.colorSpace;
    picture.notes = header.notes;
    RowReader reader(text);
    std::vector<Texel> row(sides.columns);
    float* to = picture.samples.data();
    for (uint64_t y = 0; y < sides.rows; ++y) {
        reader.Read(row);
        for (const Texel& texel : row) {
            const float unit = texel[3] == 0 ? 0.0f : std::ldexp(1.0f, texel[3] - 128 - 8);
            for (size_t c = 0; c < 3; ++c)
                *to++ = static_cast<float>(texel[c]) * unit;
        }
    }
    return Upright(std::move(picture), sides.orientation);
}

}  // namespace boxcar
