// An image at another size. Texel x of the result reads the source at (x + 0.5) / S - 0.5 in its texels, S being the
// scale.
//
//   larger:   source  ->  [BSplinePrefilter]  ->  resize.ps
//   smaller:  codes   ->  SummedAreaTable     ->  resize_table.ps: kernels as wide as a texel of the result
//
// Sigg 2005 (filters); Heckbert 1986 (tables of higher order)
#pragma once

#include "runtime/passes/bspline_prefilter.h"
#include "runtime/passes/sat_filter.h"

namespace boxcar {

enum class ResizeFilter {
    Nearest,
    Linear,
    BSpline,               // smooths
    InterpolatingBSpline,  // goes through the texels
    CatmullRom,            // goes through the texels, by fewer of them
};

// Larger on both axes, or as large. Move-only. Not thread-safe.
class Enlarge {
public:
    Enlarge(Device& device, Extent2D source, Extent2D result, ResizeFilter filter);

    // Returns the result, RGBA32F. Cost a texel: 1 load for Nearest, else 16.
    const Image& Record(CommandList& commands, const Image& source);

private:
    Extent2D m_source;
    Pipeline m_pipeline;
    std::optional<BSplinePrefilter> m_prefilter;
    Image m_result;
};

struct ShrinkDesc {
    Extent2D source = {};
    Extent2D result = {};
    uint32_t order = 2;  // 2: a tent, what linear interpolation is; 3: a parabolic kernel, nearly the cubic B-spline
    SATCodes codes = {};
};

// Smaller on an axis at least. Move-only. Not thread-safe.
class Shrink {
public:
    // Throws Error: the sum under the kernel may not fit into 64 bits; the line names the widest that does.
    Shrink(Device& device, const ShrinkDesc& desc);

    // Returns the result, RGBA32F. `codes`: as of SummedAreaTable, two words. Cost a texel: 121 or 361 loads of two
    // words.
    const Image& Record(CommandList& commands, TexelWords codes);

private:
    ShrinkDesc m_desc;
    SummedAreaTable m_table;
    Pipeline m_pipeline;
    Image m_result;
};

}  // namespace boxcar
