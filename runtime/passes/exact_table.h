// The exact summed-area table of light that a shader has just drawn.
//
//   source, W x H floats  ->  sat_encode.ps  ->  codes  ->  SummedAreaTable  ->  table
//
// A table of floats over a megapixel is off by a code or two of eight bits, and where the sun is in it by far more;
// one of whole numbers loses only what the rounding of each texel does, which no box makes larger.
#pragma once

#include "runtime/passes/sat_filter.h"

namespace boxcar {

struct ExactTableDesc {
    Extent2D extent;  // texels; of the source and of the table
    SATPrecision precision = SATPrecision::U32;
    uint32_t order = 1;
    uint32_t taps = 4;
    SATCodes codes = {};  // round(v * scale), at the most `largest`; light is not negative
};

// Device memory: SummedAreaTableBytes and 16 bytes a texel and word. Move-only. Not thread-safe.
class ExactTable {
public:
    // Throws Error as SummedAreaTable does; and: FP32; codes that may be negative.
    ExactTable(Device& device, const ExactTableDesc& desc);

    // Returns the table, readable by shaders up to the next Record() on the same object.
    TexelWords Record(CommandList& commands, const Image& source);

private:
    ExactTableDesc m_desc;
    Pipeline m_encode;
    WordImages m_codes;
    SummedAreaTable m_table;
};

}  // namespace boxcar
