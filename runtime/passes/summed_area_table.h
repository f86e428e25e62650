// Builds the summed-area table of an image on the device.
//
//   source, W x H  ->  [- bias]  ->  P(W) passes along x  ->  P(H) passes along y  ->  table, W x H
//
//   P(n) = ceil(log n / log taps). Each pass adds `taps` texels, taps^i apart in the i-th of its axis, into the other
//   of two targets, and leaves out the texels that hold their final sum in both. The last pass of an axis adds only
//   as many as are left: 512 texels with 16 taps take passes of 16, 16 and 2. A table of order n takes the passes of
//   each axis n times. hlsl/boxcar/sat_build.hlsli is the arithmetic of one pass; hlsl/boxcar/sat.hlsli,
//   sat_exact.hlsli and sat_order.hlsli read the table; sat_filter.h filters with it.
//
// This is the one stage that builds tables. It does so by the papers' raster passes.
//
// Hensley 2005, sect. 3 and 4; Scheuermann 2005 (SATPass)
#pragma once

#include <array>
#include <glm/ext/vector_int2.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/command_list.h"
#include "runtime/passes/texel_words.h"

namespace boxcar {

// How a pass finds its taps. Both give the same bits.
enum class TapAddressing {
    Interpolated,  // uvs from the vertex shader, a sampler with border 0: as the papers do. Floats from the corner
                   // only
    Integer,       // texel addresses in the pixel shader
};

// Where the sums start.
enum class SATOrigin {
    Corner,  // upper left
    Center,  // the middle: four quadrants, each summed away from it. Rounds two bits less (Hensley 2005, sect. 4.2.2)
    LowerLeft,  // as OpenGL counts; rows still lie from the top (Hensley 2005, sect. 2)
};

// The corner of texels that the sums of `origin` start from.
glm::ivec2 OriginTexels(SATOrigin origin, Extent2D extent);

struct SummedAreaTableDesc {
    Extent2D extent;  // texels; of the source and of the table
    SATPrecision precision = SATPrecision::FP32;
    uint32_t order = 1;  // how often sums are taken: 1, and 2 or 3 for integers
    uint32_t taps = 4;   // texels added per pass: 2, 4, 8 or 16. More taps: fewer passes, more samples in each.
    TapAddressing addressing = TapAddressing::Interpolated;  // where it can be had; else Integer
    SATOrigin origin = SATOrigin::Corner;
};

// Passes along an axis of `sizeTexels`: the smallest P with taps^P >= sizeTexels, in integers.
uint32_t SummedAreaTablePassCount(uint32_t sizeTexels, uint32_t taps);

// Texels that the pass of `strideTexels` adds: the fewest of taps, taps / 2, .. that finish an axis of `sizeTexels`.
uint32_t SummedAreaTablePassTaps(uint32_t taps, uint32_t strideTexels, uint32_t sizeTexels);

// Bits that the papers give a table of order n so that it never wraps: n (log2 W + log2 H) + those of a sample. 24
// for 256 x 256 texels of 8 bits, 40 for the second order of them. Tables of integers need only those of the sums
// under the filter (hlsl/boxcar/sat_range.h).
//
// Hensley 2005, sect. 2.1 and 2.2
double SummedAreaTableBits(Extent2D extent, uint32_t sampleBits, uint32_t order = 1);

// Device memory of a table while it is built: 32 bytes a texel for FP32 and U32, 64 for U64.
uint64_t SummedAreaTableBytes(Extent2D extent, SATPrecision precision);

// Holds the pipelines and the two targets: SummedAreaTableBytes. Move-only. Not thread-safe.
class SummedAreaTable {
public:
    // Throws Error: extent is 0 or over the device's limit; taps is not one of the four; the order is not one of the
    // precision's. The message names the value and the limit.
    SummedAreaTable(Device& device, const SummedAreaTableDesc& desc);

    // Appends the passes and their barriers to `commands`; returns the table, readable by shaders from this point of
    // `commands` up to the next Record() on the same object. `source` is not written. A 1 x 1 source is its own
    // table: where no pass is needed, the source itself is returned.
    //
    //   source  RGBA32F for FP32; RGBA32UI codes for U32; their lower and upper words for U64 (two's complement)
    //   bias    one texel that is taken off every texel, in the source's units; the reader adds it back. FP32 only
    TexelWords Record(CommandList& commands, TexelWords source, const Image* bias = nullptr);

    // The same, but only the first `passes` of Passes(): what the steps in between look like (Hensley 2005, Fig. 3).
    TexelWords RecordFirst(CommandList& commands, TexelWords source, uint32_t passes, const Image* bias = nullptr);

    uint32_t Passes() const { return static_cast<uint32_t>(m_steps.size()); }

    // Texels that pass `pass` adds.
    uint32_t TapsOf(uint32_t pass) const { return m_steps.at(pass).taps; }

    const SummedAreaTableDesc& Desc() const { return m_desc; }

private:
    struct Step {
        std::string name;
        uint32_t taps;
        glm::ivec2 strideTexels;
        Rect area;
    };

    void AddAxis(int axis, uint32_t time);
    PipelineDesc PassShaders(uint32_t taps) const;
    const WordImages& Back() const { return m_targets[1 - m_front]; }
    TexelWords Swap();

    SummedAreaTableDesc m_desc;
    std::vector<Step> m_steps;
    std::map<uint32_t, Pipeline> m_passes;  // by taps
    std::optional<Pipeline> m_takeOffBias;
    std::array<WordImages, 2> m_targets;
    size_t m_front = 0;
};

}  // namespace boxcar
