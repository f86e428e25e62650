#include "samples/app/bands.h"

#include <algorithm>

namespace boxcar {

std::vector<Band> PlanBands(Extent2D extent, uint32_t reachRows, uint64_t maxTexels) {
    const uint32_t height = extent.heightTexels;
    const uint64_t maxRows = maxTexels / extent.widthTexels;
    if (maxRows >= height || maxRows <= 2 * uint64_t{reachRows}) return {{0, height, 0, height}};
    const uint32_t rows = static_cast<uint32_t>(maxRows) - 2 * reachRows;
    std::vector<Band> bands;
    for (uint32_t first = 0; first < height; first += rows) {
        const uint32_t count = std::min(rows, height - first);
        const uint32_t firstRead = first > reachRows ? first - reachRows : 0;
        const uint32_t endRead = std::min(first + count + reachRows, height);
        bands.push_back({first, count, firstRead, endRead - firstRead});
    }
    return bands;
}

}  // namespace boxcar
