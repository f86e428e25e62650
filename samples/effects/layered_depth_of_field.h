// Depth of field without bleeding: the scene in layers of depth, each blurred by itself together with its coverage,
// and put behind one another. Silhouettes out of focus become soft, what is sharp stays within its own.
//
//   for each layer of depth, the nearest first:
//     nearest, hidden  ->  lens_layer.ps  ->  light times share, share
//                      ->  ExactTable     ->  lens_over.ps: over a disc of the layer's width, behind what is there
//
// Layers overlap, and a surface between two of them belongs to both: no seam shows where one ends. Their number does
// not depend on how wide the circles become, and neither does the time.
//
// Limits: no light from outside the picture; two surfaces a texel, those behind them are continued by what is seen of
// them.
//
// Beyond the papers (Hensley 2005, sect. 5.4 names the bleeding as a drawback)
#pragma once

#include "runtime/passes/exact_table.h"
#include "runtime/ping_pong.h"
#include "samples/effects/depth_of_field.h"

namespace boxcar {

// Light up to 16, in codes of 1 / 16384; the words of a table hold any sum of them over so large a circle. Brighter
// light and larger circles become these.
constexpr SATCodes kLensCodes{16384, 16 * 16384 - 1, false};
constexpr float kLargestLensTexels = 127;

struct LayeredDepthOfFieldDesc {
    Extent2D extent = {};  // texels
    uint32_t boxes = 8;    // of equal height, that stand for a circle
    uint32_t sides = 0;    // of an aperture with so many blades, 3 to 16; 0: round
};

// Device memory: that of ExactTable and 48 bytes a texel. Move-only. Not thread-safe.
class LayeredDepthOfField {
public:
    // Throws Error as ExactTable does.
    LayeredDepthOfField(Device& device, const LayeredDepthOfFieldDesc& desc);

    // Returns the picture, RGBA32F.
    //
    //   nearest           linear light; disparity, 1 / depth, in alpha
    //   hidden            the same of what is seen when `nearest` is taken away
    //   largestDisparity  of the nearest point of the scene
    //   layersPerSide     before the focus, and behind it; 1 at least
    const Image& Record(CommandList& commands, const Image& nearest, const Image& hidden, const Lens& lens,
                        float largestDisparity, int layersPerSide);

    // The layer that was recorded last: the farthest.
    const Image& Layer() const { return m_layer; }

private:
    LayeredDepthOfFieldDesc m_desc;
    Pipeline m_take, m_over;
    Image m_layer;
    ExactTable m_table;
    PingPong m_light;
};

}  // namespace boxcar
