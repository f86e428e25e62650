// Filters and tables over integers, exact: every sum is a whole number in 128 bits, to be compared digit by digit.
// The whole form of the kernel of order n is n rows of W ones convolved, over W^n, centred on a texel: Heckbert 1986,
// "Filtering by repeated integration", with sums in place of integrals. Not written from the shaders.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/reference/order.h"

namespace boxcar::reference {

struct CodeImage {
    int width = 0;
    int height = 0;
    std::vector<std::array<int64_t, 4>> texels;

    const std::array<int64_t, 4>& At(int x, int y) const { return texels[static_cast<size_t>(y) * width + x]; }
};

struct WideImage {
    int width = 0;
    int height = 0;
    std::vector<std::array<__int128, 4>> texels;

    const std::array<__int128, 4>& At(int x, int y) const { return texels[static_cast<size_t>(y) * width + x]; }
};

// `order` rows of `width` ones convolved: order * (width - 1) + 1 weights, whose sum is width^order. A texel is at
// the middle of them only if their number is odd.
inline std::vector<__int128> WholeWeights(int order, int width) {
    if (order < 1 || order > 3) throw std::invalid_argument("order is none of 1, 2, 3");
    if (width < 1) throw std::invalid_argument("width is below 1");
    if (order * (width - 1) % 2 != 0) throw std::invalid_argument("order * (width - 1) is odd: no centre texel");
    std::vector<__int128> weights{1};
    for (int n = 0; n < order; n++) {
        std::vector<__int128> wider(weights.size() + width - 1, 0);
        for (size_t i = 0; i < weights.size(); i++)
            for (int k = 0; k < width; k++)
                wider[i + k] += weights[i];
        weights = wider;
    }
    return weights;
}

// The whole form at the texel (x, y), which may lie outside, times w^order * h^order (Clip: times WholeMass).
inline std::array<__int128, 4> WholeSum(const CodeImage& image, int order, int x, int y, int w, int h,
                                        Border border) {
    const std::vector<__int128> columns = WholeWeights(order, w);
    const std::vector<__int128> rows = WholeWeights(order, h);
    const int left = x - order * (w - 1) / 2;
    const int top = y - order * (h - 1) / 2;
    std::array<__int128, 4> sum{};
    for (size_t j = 0; j < rows.size(); j++) {
        const int atY = MapTexel(top + static_cast<int>(j), image.height, border);
        if (atY == kOutside) continue;
        for (size_t i = 0; i < columns.size(); i++) {
            const int atX = MapTexel(left + static_cast<int>(i), image.width, border);
            if (atX == kOutside) continue;
            for (size_t c = 0; c < 4; c++)
                sum[c] += columns[i] * rows[j] * image.At(atX, atY)[c];
        }
    }
    return sum;
}

// What the kernel weighs on an axis of `size` texels: with Clip only inside, else width^order.
inline __int128 WholeAxisMass(int size, int order, int centre, int width, Border border) {
    const std::vector<__int128> weights = WholeWeights(order, width);
    const int first = centre - order * (width - 1) / 2;
    __int128 mass = 0;
    for (size_t i = 0; i < weights.size(); i++) {
        const bool outside = MapTexel(first + static_cast<int>(i), size, border) == kOutside;
        if (border != Border::Clip || !outside) mass += weights[i];
    }
    return mass;
}

// The divisor that makes WholeSum a mean; 0 if Clip finds nothing inside.
inline __int128 WholeMass(const CodeImage& image, int order, int x, int y, int w, int h, Border border) {
    return WholeAxisMass(image.width, order, x, w, border) * WholeAxisMass(image.height, order, y, h, border);
}

// S_n: the image summed `order` times along x, then as often along y. No sum may pass 127 bits.
inline WideImage RepeatedTable(const CodeImage& image, int order) {
    WideImage table{image.width, image.height, {}};
    for (const auto& code : image.texels)
        table.texels.push_back({code[0], code[1], code[2], code[3]});
    const auto add = [&](int toX, int toY, int fromX, int fromY) {
        for (size_t c = 0; c < 4; c++)
            table.texels[static_cast<size_t>(toY) * table.width + toX][c] += table.At(fromX, fromY)[c];
    };
    for (int n = 0; n < order; n++)
        for (int y = 0; y < table.height; y++)
            for (int x = 1; x < table.width; x++)
                add(x, y, x - 1, y);
    for (int n = 0; n < order; n++)
        for (int y = 1; y < table.height; y++)
            for (int x = 0; x < table.width; x++)
                add(x, y, x, y - 1);
    return table;
}

// What an unsigned integer of `bits` bits (1 to 126) keeps: the value modulo 2^bits, never negative. Sums,
// differences and whole multiples may be wrapped at every step or only at the end, the result is the same.
inline __int128 WrapTo(__int128 value, int bits) {
    if (bits < 1 || bits > 126) throw std::invalid_argument("bits is not in 1 to 126");
    const __int128 modulus = static_cast<__int128>(1) << bits;
    return (value % modulus + modulus) % modulus;
}

inline WideImage WrapTo(WideImage table, int bits) {
    for (auto& texel : table.texels)
        for (__int128& value : texel)
            value = WrapTo(value, bits);
    return table;
}

// WholeSum of order 1 with Clip (or Zero: the sums are the same) for pictures too large for it. Takes the rows of
// codes from the top down, keeps the sum of each column over the last h of them and slides a window of w columns over
// those. w and h are odd. A row holds `width` texels of `channels` codes each, and so do the sums. 64 bits hold them
// while w * h is at most 2^32.
//
//   for each row:       if (auto sums = boxes.Feed(row)) Use(*sums);  // from the top, h / 2 rows late
//   h / 2 times more:   if (auto sums = boxes.FeedOutside()) Use(*sums);
class WholeBoxSums {
public:
    WholeBoxSums(int width, int w, int h, int channels = 1)
        : m_width(width), m_w(w), m_h(h), m_channels(channels), m_columns(static_cast<size_t>(width) * channels, 0) {
        if (width < 1 || channels < 1) throw std::invalid_argument("width or channels is below 1");
        if (w < 1 || h < 1 || w % 2 == 0 || h % 2 == 0) throw std::invalid_argument("w and h must be odd");
    }

    // Row y of the picture. Returns the sums of the boxes centred on row y - h / 2, if that is a row of it.
    std::optional<std::vector<uint64_t>> Feed(std::span<const uint32_t> row) {
        if (row.size() != m_columns.size()) throw std::invalid_argument("row is not width * channels long");
        return Advance({row.begin(), row.end()});
    }

    // A row below the picture.
    std::optional<std::vector<uint64_t>> FeedOutside() { return Advance(std::vector<uint32_t>(m_columns.size(), 0)); }

private:
    std::optional<std::vector<uint64_t>> Advance(std::vector<uint32_t> row) {
        for (size_t i = 0; i < row.size(); i++)
            m_columns[i] += row[i];
        m_rows.push_back(std::move(row));
        if (m_rows.size() > static_cast<size_t>(m_h)) {
            for (size_t i = 0; i < m_columns.size(); i++)
                m_columns[i] -= m_rows.front()[i];
            m_rows.pop_front();
        }
        if (m_rows.size() <= static_cast<size_t>(m_h / 2)) return std::nullopt;

        std::vector<uint64_t> sums(m_columns.size());
        for (int c = 0; c < m_channels; c++) {
            uint64_t window = 0;  // the columns x - w / 2 .. x + w / 2 that there are
            for (int x = -(m_w / 2); x < m_width; x++) {
                if (x + m_w / 2 < m_width) window += Column(x + m_w / 2, c);
                if (x - m_w / 2 - 1 >= 0) window -= Column(x - m_w / 2 - 1, c);
                if (x >= 0) sums[static_cast<size_t>(x) * m_channels + c] = window;
            }
        }
        return sums;
    }

    uint64_t Column(int x, int c) const { return m_columns[static_cast<size_t>(x) * m_channels + c]; }

    int m_width, m_w, m_h, m_channels;
    std::vector<uint64_t> m_columns;
    std::deque<std::vector<uint32_t>> m_rows;  // the last h
};

}  // namespace boxcar::reference
