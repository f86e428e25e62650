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

#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/depth_of_field.h"
#include "runtime/passes/exact_table.h"
#include "runtime/ping_pong.h"

namespace boxcar {

// Brighter light becomes this.
constexpr float kBrightestLensLight = 16;

// Light up to that in steps of 2^-bits. 16 bits are within 0.03 codes of 8 bits, 20 within 0.002; 28 within 0.1 codes
// of 16 bits.
constexpr SATCodes LensCodes(int bits) {
    const auto scale = static_cast<float>(uint64_t{1} << bits);
    return {scale, double{kBrightestLensLight} * scale, false};
}

struct LayeredDepthOfFieldDesc {
    Extent2D extent = {};       // texels
    uint32_t boxes = 8;         // of equal height, that stand for a circle
    uint32_t sides = 0;         // of an aperture with so many blades, 3 to 16; 0: round
    float largestTexels = 127;  // the largest circle; larger ones become this
    SATCodes codes = LensCodes(16);
};

// Device memory: that of ExactTable and 48 bytes a texel. Move-only. Not thread-safe.
class LayeredDepthOfField {
public:
    // Throws Error as ExactTable does.
    LayeredDepthOfField(Device& device, const LayeredDepthOfFieldDesc& desc);

    // Returns the picture, RGBA32F.
    //
    //   nearest           linear light; disparity, 1 / depth, in alpha
    //   hidden            the same of what is seen when `nearest` is taken away. Null: not known; where something
    //                     before the focus lets it through, it is continued from what is seen beside it
    //   largestDisparity  of the nearest point of the scene
    //   layersPerSide     before the focus, and behind it; 1 at least
    const Image& Record(CommandList& commands, const Image& nearest, const Image* hidden, const Lens& lens,
                        float largestDisparity, int layersPerSide);

    // Of the tables.
    SATPrecision Precision() const { return m_precision; }

    // The layer that was recorded last: the farthest.
    const Image& Layer() const { return m_layer; }

private:
    // One more layer behind the others: shares by `knots`, blurred with circles of `diameterTexels`.
    void Put(CommandList& commands, const Image& nearest, const Image& hidden, const LensLayerConstants& knots,
             float diameterTexels, float opacity, bool isLast);

    LayeredDepthOfFieldDesc m_desc;
    SATPrecision m_precision;
    Pipeline m_take, m_over;
    Image m_layer;
    ExactTable m_table;
    PingPong m_light;
};

}  // namespace boxcar
