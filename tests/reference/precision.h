// Tables in numbers of few bits, from the definition: every sum is made in double and then rounded to the number's
// own grid. Slow and obvious. Written from the formats (IEEE 754 half and single; ATI's 1-7-16 of Hensley 2005) and
// from Hensley 2005, sect. 3 and 4, not from the shaders.
#pragma once

#include <cmath>
#include <functional>
#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "tests/reference/box.h"

namespace boxcar::reference {

// A binary floating-point format.
struct NumberFormat {
    int storedBits;       // of the mantissa, without the leading 1
    int leastExponent;    // of a number with a leading 1
    int largestExponent;  // of a finite number
    bool subnormals;
    bool truncates;  // towards 0; else to the nearest, ties to even
};

inline constexpr NumberFormat kHalf{10, -14, 15, true, false};
inline constexpr NumberFormat kAti24{16, -62, 63, false, false};
inline constexpr NumberFormat kAti24Truncated{16, -62, 63, false, true};
inline constexpr NumberFormat kSingle{23, -126, 127, true, false};

inline double RoundTo(const NumberFormat& format, double value) {
    if (value == 0 || !std::isfinite(value)) return value;
    const int exponent = std::max(std::ilogb(value), format.leastExponent);
    const double quantum = std::ldexp(1.0, exponent - format.storedBits);
    const double multiple = value / quantum;
    const double rounded = quantum * (format.truncates ? std::trunc(multiple) : std::nearbyint(multiple));
    if (!format.subnormals && std::abs(rounded) < std::ldexp(1.0, format.leastExponent))
        return std::copysign(0.0, value);
    const double largest = std::ldexp(2 - std::ldexp(1.0, -format.storedBits), format.largestExponent);
    if (std::abs(rounded) <= largest) return rounded;
    return std::copysign(format.truncates ? largest : std::numeric_limits<double>::infinity(), value);
}

// How a table is summed and stored.
struct Arithmetic {
    NumberFormat added = kSingle;   // the sum of two numbers
    NumberFormat stored = kSingle;  // what a pass leaves behind
};
inline constexpr Arithmetic kArithmeticFp16{kSingle, kHalf};
inline constexpr Arithmetic kArithmeticFp24{kAti24, kAti24};
inline constexpr Arithmetic kArithmeticFp24Truncated{kAti24Truncated, kAti24Truncated};
inline constexpr Arithmetic kArithmeticFp32{};

// Running sums of `line` by passes of `taps` texels: pass i adds those at distances 0, r^i, 2 r^i, .. as a balanced
// tree.
inline std::vector<double> DoublingScan(std::vector<double> line, uint32_t taps, const Arithmetic& arithmetic) {
    const int size = static_cast<int>(line.size());
    for (int stride = 1; stride < size; stride *= static_cast<int>(taps)) {
        const std::vector<double> in = line;
        const std::function<double(int, int)> sum = [&](int at, int count) {
            if (at < 0) return 0.0;
            if (count == 1) return in[at];
            return RoundTo(arithmetic.added, sum(at, count / 2) + sum(at - count / 2 * stride, count / 2));
        };
        for (int i = 0; i < size; i++)
            line[i] = RoundTo(arithmetic.stored, sum(i, static_cast<int>(taps)));
    }
    return line;
}

// Running sums, each from the one before.
inline std::vector<double> SerialScan(std::vector<double> line, const Arithmetic& arithmetic) {
    for (size_t i = 1; i < line.size(); i++)
        line[i] = RoundTo(arithmetic.stored, RoundTo(arithmetic.added, line[i - 1] + line[i]));
    return line;
}

using Scan = std::function<std::vector<double>(std::vector<double>)>;

// `scan` of each row, then of each column, outwards from the middle: a texel at or right of it sums leftwards.
inline DoubleImage ScanOutwards(DoubleImage image, int middleX, int middleY, const Scan& scan) {
    const auto run = [&](int lines, int size, int middle, const std::function<double&(int line, int at)>& at) {
        for (int line = 0; line < lines; line++) {
            std::vector<double> before, after;
            for (int i = middle - 1; i >= 0; i--)
                before.push_back(at(line, i));
            for (int i = middle; i < size; i++)
                after.push_back(at(line, i));
            before = scan(before);
            after = scan(after);
            for (int i = 0; i < size; i++)
                at(line, i) = i < middle ? before[middle - 1 - i] : after[i - middle];
        }
    };
    for (int c = 0; c < 4; c++) {
        const auto texel = [&](int x, int y) -> double& {
            return image.texels[static_cast<size_t>(y) * image.width + x][c];
        };
        run(image.height, image.width, middleX, [&](int y, int x) -> double& { return texel(x, y); });
        run(image.width, image.height, middleY, [&](int x, int y) -> double& { return texel(x, y); });
    }
    return image;
}

struct RoundedTable {
    Arithmetic arithmetic;
    glm::vec4 bias{0};
    int middleX = 0;
    int middleY = 0;
    DoubleImage entries;
};

// What is summed: the texels less the bias, rounded.
inline DoubleImage RoundedTexels(DoubleImage image, glm::vec4 bias, const Arithmetic& arithmetic) {
    for (glm::dvec4& texel : image.texels)
        for (int c = 0; c < 4; c++)
            texel[c] = RoundTo(arithmetic.stored, RoundTo(kSingle, texel[c] - bias[c]));
    return image;
}

inline RoundedTable BuildRounded(const DoubleImage& image, const Arithmetic& arithmetic, glm::vec4 bias,
                                 bool centered, uint32_t taps) {
    RoundedTable table{arithmetic, bias, centered ? image.width / 2 : 0, centered ? image.height / 2 : 0, {}};
    table.entries =
        ScanOutwards(RoundedTexels(image, bias, arithmetic), table.middleX, table.middleY,
                     [&](std::vector<double> line) { return DoublingScan(std::move(line), taps, arithmetic); });
    return table;
}

// The box of one texel, read in float32, differences along x first.
inline glm::dvec4 ReadTexel(const RoundedTable& table, int x, int y) {
    const auto integral = [&](int cornerX, int cornerY, int c) -> double {
        if (cornerX == table.middleX || cornerY == table.middleY) return 0;
        const int atX = cornerX > table.middleX ? cornerX - 1 : cornerX;
        const int atY = cornerY > table.middleY ? cornerY - 1 : cornerY;
        const double sign = (cornerX < table.middleX) == (cornerY < table.middleY) ? 1 : -1;
        return sign * table.entries.At(atX, atY)[c];
    };
    const auto single = [](double value) { return RoundTo(kSingle, value); };
    glm::dvec4 texel;
    for (int c = 0; c < 4; c++) {
        const double top = single(integral(x + 1, y, c) - integral(x, y, c));
        const double bottom = single(integral(x + 1, y + 1, c) - integral(x, y + 1, c));
        texel[c] = single(single(bottom - top) + table.bias[c]);
    }
    return texel;
}

// 10 log10(sum I^2 / sum (I - R)^2) over the first `channels` channels. Hensley 2005, sect. 4.1
inline double IdentitySnrDb(const DoubleImage& image, const RoundedTable& table, int channels) {
    double signal = 0, noise = 0;
    for (int y = 0; y < image.height; y++) {
        for (int x = 0; x < image.width; x++) {
            const glm::dvec4 read = ReadTexel(table, x, y);
            for (int c = 0; c < channels; c++) {
                const double value = image.At(x, y)[c];
                signal += value * value;
                noise += (value - read[c]) * (value - read[c]);
            }
        }
    }
    return 10 * std::log10(signal / noise);
}

}  // namespace boxcar::reference
