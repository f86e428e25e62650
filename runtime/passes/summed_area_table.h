// Builds the summed-area table of an image on the device.
//
//   source, W x H  ->  [- bias]  ->  P(W) passes along x  ->  P(H) passes along y  ->  table, W x H
//
//   P(n) = ceil(log n / log taps). Each pass adds `taps` texels, taps^i apart in the i-th of its axis, into the other
//   of two targets, and leaves out the texels that hold their final sum in both. The last pass of an axis adds only
//   as many as are left: 512 texels with 16 taps take passes of 16, 16 and 2. hlsl/boxcar/sat_build.hlsli is the
//   arithmetic of one pass; hlsl/boxcar/sat.hlsli reads the table; box_filter.h filters with it.
//
// Hensley 2005, sect. 3 and 4; Scheuermann 2005 (SATPass)
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/command_list.h"
#include "runtime/ping_pong.h"

namespace boxcar {

// How a pass finds its taps. Both give the same bits.
enum class TapAddressing {
    Interpolated,  // uvs from the vertex shader, a sampler with border 0: as the papers do
    Integer,       // texel addresses in the pixel shader
};

struct SummedAreaTableDesc {
    Extent2D extent;    // texels; of the source and of the table
    uint32_t taps = 4;  // texels added per pass: 2, 4, 8 or 16. More taps: fewer passes, more samples in each.
    TapAddressing addressing = TapAddressing::Interpolated;
    glm::vec4 bias{0};  // taken off every texel, in the source's units; the reader adds it back
};

// Passes along an axis of `sizeTexels`: the smallest P with taps^P >= sizeTexels, in integers.
uint32_t SummedAreaTablePassCount(uint32_t sizeTexels, uint32_t taps);

// Holds the pipelines and the two targets: 32 bytes of device memory per texel. Move-only. Not thread-safe.
class SummedAreaTable {
public:
    // Throws Error: extent is 0 or over the device's limit; taps is not one of the four. The message names the value
    // and the limit.
    SummedAreaTable(Device& device, const SummedAreaTableDesc& desc);

    // Appends the passes and their barriers to `commands`; returns the table, RGBA32F, readable by shaders from this
    // point of `commands` up to the next Record() on the same object. `source` is not written. A 1 x 1 source is its
    // own table: where no pass is needed, the source itself is returned.
    const Image& Record(CommandList& commands, const Image& source);

    // The same, but only the first `passes` of Passes(): what the steps in between look like (Hensley 2005, Fig. 3).
    const Image& RecordFirst(CommandList& commands, const Image& source, uint32_t passes);

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

    void AddAxis(uint32_t sizeTexels, glm::ivec2 axis);

    SummedAreaTableDesc m_desc;
    std::vector<Step> m_steps;
    std::map<uint32_t, Pipeline> m_passes;  // by taps
    std::optional<Pipeline> m_takeOffBias;
    PingPong m_targets;
};

}  // namespace boxcar
