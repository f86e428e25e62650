// An image at another size. The centre of texel x of the result lies (x + 0.5) steps behind the source's edge.
//
//   larger:   source  ->  [BSplinePrefilter]  ->  resize.ps
//   smaller:  codes   ->  SummedAreaTable     ->  resize_table.ps: kernels as wide as a texel of the result
//
// Sigg 2005 (filters); Heckbert 1986 (tables of higher order)
#pragma once

#include "hlsl/constants/bspline_constants.h"
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

struct ResizeDesc {
    Extent2D source = {};
    Extent2D result = {};
    float2 stepTexels = {};  // of the source, from one texel of the result to the next; above 0
    ResizeFilter filter = ResizeFilter::InterpolatingBSpline;
};

// Whether the result's texels are larger than the source's on an axis and its filter then takes the mean over them.
bool IsShrunk(const ResizeDesc& desc);

// For what is not shrunk. Move-only. Not thread-safe.
class Enlarge {
public:
    Enlarge(Device& device, const ResizeDesc& desc);

    // Returns the result, RGBA32F. Cost a texel: 1 load for Nearest, else 16.
    const Image& Record(CommandList& commands, const Image& source);

private:
    ResizeConstants m_constants;
    Pipeline m_pipeline;
    std::optional<BSplinePrefilter> m_prefilter;
    Image m_result;
};

// For what is shrunk: under a tent, as linear interpolation is; for BSpline under a parabola. Move-only. Not
// thread-safe.
class Shrink {
public:
    // Throws Error: the sum under the kernel may not fit into 64 bits; the line names the widest that does.
    Shrink(Device& device, const ResizeDesc& desc, const SATCodes& codes);

    // Returns the result, RGBA32F. `codes`: as of SummedAreaTable, two words. Cost a texel: 121 or 361 loads of two
    // words.
    const Image& Record(CommandList& commands, TexelWords codes);

private:
    ResizeConstants m_constants;
    SummedAreaTable m_table;
    Pipeline m_pipeline;
    Image m_result;
};

}  // namespace boxcar
