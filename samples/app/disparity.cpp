#include "samples/app/disparity.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace boxcar {
namespace {

constexpr int64_t kFar = int64_t{1} << 40;

// For each place x of a line the index i that makes (x - i)^2 + height[i] least: the lower envelope of parabolas.
std::vector<int64_t> NearestOf(const std::vector<int64_t>& height) {
    const auto count = static_cast<int64_t>(height.size());
    std::vector<int64_t> parabola;  // of the envelope, from the left
    std::vector<double> beginsAt;   // where each takes over
    for (int64_t i = 0; i < count; i++) {
        double at = -std::numeric_limits<double>::infinity();
        while (!parabola.empty()) {
            const int64_t last = parabola.back();
            at = static_cast<double>(height[i] + i * i - height[last] - last * last) /
                 static_cast<double>(2 * (i - last));
            if (at > beginsAt.back()) break;
            parabola.pop_back();
            beginsAt.pop_back();
            at = -std::numeric_limits<double>::infinity();
        }
        parabola.push_back(i);
        beginsAt.push_back(at);
    }
    std::vector<int64_t> nearest(height.size());
    size_t k = 0;
    for (int64_t x = 0; x < count; x++) {
        while (k + 1 < parabola.size() && beginsAt[k + 1] < static_cast<double>(x))
            k++;
        nearest[static_cast<size_t>(x)] = parabola[k];
    }
    return nearest;
}

}  // namespace

bool FillUnknown(std::vector<float>& depth, Extent2D extent) {
    const size_t width = extent.widthTexels, height = extent.heightTexels;
    const auto known = [](float value) { return !std::isnan(value); };
    if (std::ranges::none_of(depth, known)) return false;

    // Down each column: the nearest known row, and how far it is, squared.
    std::vector<uint32_t> row(depth.size());
    std::vector<int64_t> distance(depth.size(), kFar);
    const auto look = [&](size_t x, size_t y, int64_t& last) {
        const size_t at = y * width + x;
        if (known(depth[at])) last = static_cast<int64_t>(y);
        const int64_t away = (static_cast<int64_t>(y) - last) * (static_cast<int64_t>(y) - last);
        if (last >= 0 && away < distance[at]) {
            distance[at] = away;
            row[at] = static_cast<uint32_t>(last);
        }
    };
    for (size_t x = 0; x < width; x++) {
        int64_t above = -1, below = -1;
        for (size_t y = 0; y < height; y++)
            look(x, y, above);
        for (size_t y = height; y-- > 0;)
            look(x, y, below);
    }

    // Along each row: the column whose known texel is nearest.
    const std::vector<float> source = depth;
    for (size_t y = 0; y < height; y++) {
        const auto begin = distance.begin() + static_cast<std::ptrdiff_t>(y * width);
        const std::vector<int64_t> column =
            NearestOf(std::vector<int64_t>(begin, begin + static_cast<std::ptrdiff_t>(width)));
        for (size_t x = 0; x < width; x++) {
            const auto from = static_cast<size_t>(column[x]);
            depth[y * width + x] = source[row[y * width + from] * width + from];
        }
    }
    return true;
}

}  // namespace boxcar
