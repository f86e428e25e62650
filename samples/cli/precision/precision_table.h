// The precision laboratory's tables: one image, summed in several arithmetics and by several builders.
//
//   source, W x H  ->  less the bias, rounded  ->  passes along x, along y, each rounded  ->  table  ->  box means
//
// Kept apart from runtime/passes: what is measured here is what SummedAreaTable does not do. Its own float32 table is
// bit for bit the one of Precision::Fp32, SATOrigin::Corner, Builder::Raster (PrecisionTable.IsTheProductsInFloat32).
//
// Crow 1984; Green 2003; Hensley 2005, sect. 4; Scheuermann 2005
#pragma once

#include <glm/vec4.hpp>
#include <map>
#include <string>

#include "runtime/command_list.h"
#include "runtime/passes/summed_area_table.h"
#include "runtime/ping_pong.h"

namespace boxcar {

// The arithmetic of sums and entries; hlsl/shaders/precision_number.hlsli and precision_round.hlsli define it. Boxes
// are read from the table in float32, but under U32, where they are whole sums.
enum class Precision {
    Fp16,           // float32 sums in half-float targets: a store rounds
    Fp24,           // ATI's 1-7-16, every addition and store to the nearest
    Fp24Truncated,  // the same, towards 0
    Fp32,
    U32,  // whole codes modulo 2^32
};

enum class Builder {
    Raster,  // recursive doubling by whole addresses
    Frame,   // recursive doubling by interpolated uv, a black frame of a texel and clamping: Fp32, 4 taps, corner
    Lines,   // Green's: every column from the one before, then every row; a serial scan: Fp16 or Fp32, corner
    Blocks,  // Crow's 16 x 16 blocks of 16-bit entries: U32 of 8-bit codes, corner;
             // hlsl/shaders/precision_blocks.hlsli
};

// The words of JSON and of the shaders' names: "fp24t", "center", "raster", ..
const char* Name(Precision precision);
const char* Name(SATOrigin origin);
const char* Name(Builder builder);

struct TableSetup {
    Precision precision = Precision::Fp32;
    glm::vec4 bias{0};  // taken off every texel before it is rounded; none under U32
    SATOrigin origin = SATOrigin::Corner;
    uint32_t taps = 4;  // 2, 4, 8 or 16
    Builder builder = Builder::Raster;
    uint32_t largestCode = 255;  // U32: a source of 1 is this code
};

// Makes pipelines and targets when they are first needed: up to 200 bytes of device memory a texel. Move-only. Not
// thread-safe.
class PrecisionTable {
public:
    PrecisionTable(Device& device, Extent2D extent);

    // Appends the passes; the table is readable up to the next Record(). `source`: RGBA32F of the extent.
    // A combination that a builder does not have (see Builder) is the caller's mistake.
    const Image& Record(CommandList& commands, const Image& source, const TableSetup& setup);

    // Appends the reading of a box of `sizeTexels` (odd, so that its corners are whole) round every texel, clipped to
    // the image. Returns its means, bias added back, RGBA32F; under U32 its sums, RGBA32UI. Readable up to the next
    // RecordBox().
    const Image& RecordBox(CommandList& commands, const Image& table, const TableSetup& setup, uint32_t sizeTexels);

private:
    const Pipeline& PipelineOf(const std::string& pixel, Format target, const std::string& vertex = "quad.vs");
    PingPong& Targets(Format format, Extent2D extent);
    const Image& Target(const std::string& name, Format format, Extent2D extent);

    const Image& RecordTexels(CommandList& commands, const Image& source, const TableSetup& setup, PingPong& targets);
    const Image& RecordRaster(CommandList& commands, const Image& source, const TableSetup& setup);
    const Image& RecordFrame(CommandList& commands, const Image& source, const TableSetup& setup);
    const Image& RecordLines(CommandList& commands, const Image& source, const TableSetup& setup);
    const Image& RecordBlocks(CommandList& commands, const Image& source, const TableSetup& setup);

    Device& m_device;
    Extent2D m_extent;
    std::map<std::string, Pipeline> m_pipelines;  // by shader and target
    std::map<std::string, PingPong> m_pairs;      // by format and extent
    std::map<std::string, Image> m_images;        // by name
};

}  // namespace boxcar
