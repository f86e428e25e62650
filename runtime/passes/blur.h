// Blurs an image with a kernel of any size, at a cost that does not depend on it.
//
//   source  ->  [Mean]  ->  [ExtendedImage]  ->  SummedAreaTable  ->  SATFilter  ->  blurred
//
// Crow 1984; Hensley 2005
#pragma once

#include "runtime/passes/extended_image.h"
#include "runtime/passes/mean.h"
#include "runtime/passes/sat_filter.h"

namespace boxcar {

// What is taken off every texel before the table is built, and added back after (Hensley 2005, sect. 4.2.1).
enum class BlurBias {
    None,
    Half,  // 0.5
    Mean,  // of the source: makes float32 round some 10 to 100 times less on a photograph; leave it for HDR
};

// How many texels to either side of it a kernel reads at the most.
Extent2D BlurReach(uint32_t order, glm::vec2 sizeTexels);

struct BlurDesc {
    Extent2D extent = {};  // texels
    SATPrecision precision = SATPrecision::FP32;
    uint32_t order = 1;  // 1 box, 2 tent, 3 parabolic; orders 2 and 3 need integers
    uint32_t boxes = 1;  // that stand for a disc or a polygon; 1 for a box. Order 1 only
    uint32_t sides = 0;  // of the polygon, 3 to 16; 0 for a disc
    SATEdge edge = SATEdge::Clip;
    uint32_t taps = 4;                     // texels added per pass while the table is built: 2, 4, 8 or 16
    SATOrigin origin = SATOrigin::Corner;  // FP32 only; not over repeated images
    BlurBias bias = BlurBias::None;        // FP32 only
    SATCodes codes = {};                   // for integers
    glm::vec2 largestTexels{1};            // the largest width and height to come; orders 2 and 3, repeated images
};

// Device memory: the table's (SummedAreaTableBytes), 16 bytes a texel for the result, a third of 16 for the mean; for
// orders 2 and 3 over repeated images the extended image as well. Move-only. Not thread-safe.
class Blur {
public:
    // Throws Error as SummedAreaTable and SATFilter do.
    Blur(Device& device, const BlurDesc& desc);

    // Returns the blurred image, RGBA32F. Throws Error as SATFilter::Record does.
    //
    //   source  as of SummedAreaTable::Record
    //   widths  of the box that the kernel is made of
    const Image& Record(CommandList& commands, TexelWords source, const SATWidths& widths);

    // Device memory of the table alone.
    uint64_t TableBytes() const { return SummedAreaTableBytes(m_table.Desc().extent, m_desc.precision); }

private:
    BlurDesc m_desc;
    std::optional<Mean> m_mean;
    std::optional<Image> m_half;
    std::optional<ExtendedImage> m_extended;
    SummedAreaTable m_table;
    SATFilter m_filter;
};

}  // namespace boxcar
