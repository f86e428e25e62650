// Pictures too large for the device at one go: bands of rows, each with as many rows more on either side as a kernel
// reaches, so that every row comes out as it would in one piece.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/format.h"

namespace boxcar {

struct Band {
    uint32_t firstRow = 0;  // of the rows it is there for
    uint32_t rows = 0;
    uint32_t firstRead = 0;  // of the rows it needs
    uint32_t rowsRead = 0;
};

// Bands of at most `maxTexels` texels to read; one band of everything where that is enough, or where the rows that a
// kernel reaches leave no room for others.
//
//   reachRows  of the kernel, to either side
std::vector<Band> PlanBands(Extent2D extent, uint32_t reachRows, uint64_t maxTexels = uint64_t{1} << 24);

}  // namespace boxcar
