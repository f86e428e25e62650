// Filters an image by reading its summed-area table round every texel.
//
//   table (of order n)  ->  one pass  ->  filtered image
//
// A kernel is made of boxes of one width: one box, two in a row (tent) or three (parabolic) for orders 1, 2, 3; or,
// of order 1, several side by side that stand for a disc.
//
// Crow 1984, sect. 2.1; Hensley 2005, sect. 2 and 4
#pragma once

#include <glm/vec2.hpp>
#include <map>

#include "runtime/passes/summed_area_table.h"

namespace boxcar {

// What lies outside the image.
enum class SATEdge {
    Clip,    // nothing: the kernel is divided by what of it lies inside, so that a constant stays constant
    Zero,    // 0: coverage fades at the rim
    Repeat,  // the image over and over
    Mirror,  // the image and its mirror image by turns; the texel at the edge comes twice
};

// What the integers of an exact table stand for.
struct SATCodes {
    float scale = 1;       // what 1 is in codes: 255, 65535, 2^24
    double largest = 255;  // the largest magnitude of a code
    bool isSigned = false;
};

// The mass that a kernel over codes may have (hlsl/boxcar/sat_range.h), rounded down.
float SATLargestMass(SATPrecision precision, const SATCodes& codes);

// Whether widths are whole as SATSumWhole takes them: whole for tents, odd for boxes and parabolic
// kernels; below 1 acts as 1.
bool SATIsWhole(glm::vec2 sizeTexels, uint32_t order);

// The largest width, a whole number (odd for order 3 and `isWhole`) of at most 32768, whose square kernel is exact in
// such a table; 0 if not even that of 1 is.
//
//   isWhole  for whole widths (SATIsWhole); else for any, as maps of widths have them
uint32_t SATLargestWidthTexels(SATPrecision precision, const SATCodes& codes, uint32_t order, bool isWhole = true);

// U32 where it is sure to hold the kernel, else U64.
SATPrecision SATExactPrecision(glm::vec2 sizeTexels, uint32_t order, bool isWhole, const SATCodes& codes);

// The kernel that stands for a Gaussian of standard deviation sigma: boxes of width widthOverSigma * sigma.
struct SATGaussian {
    uint32_t order = 1;
    float widthOverSigma = 1;
    float relativeError = 1;  // L2 distance of the two, over the Gaussian's L2 norm, in two dimensions
};

// That of the lowest order that is within `relativeError`: box 0.530, tent 0.098, parabolic 0.042, each of the width
// that is nearest to the Gaussian. Throws Error where none is.
//
// Heckbert, as in Hensley 2005, sect. 2 (repeated boxes tend to a Gaussian)
SATGaussian SATGaussianWithin(float relativeError);

struct SATFilterDesc {
    Extent2D extent;  // texels; of the result
    SATPrecision precision = SATPrecision::FP32;
    uint32_t order = 1;
    uint32_t boxes = 1;            // of equal height, that stand for a disc or a polygon; 1 for a box. Order 1 only
    uint32_t sides = 0;            // of the polygon, 3 to 16, a corner at the top; 0 for a disc
    SATEdge edge = SATEdge::Clip;  // orders 2 and 3: Clip or Zero (extended_image.h does the others)
    SATOrigin origin = SATOrigin::Corner;  // of the table; integers, and repeated images, need Corner
    Extent2D padding = {0, 0};             // the table's extent is `extent` and twice this
    SATCodes codes = {};                   // for integers
};

// The width and height of the boxes at each texel: any real; below 1 acts as 1. Without a map, orders 2 and 3 are the
// box over texels repeated on an axis where their width is whole (SATIsWhole), else the continuous kernel. With a map
// they are continuous at whole widths too, so that nothing jumps: width 1 spreads a texel a little (docs/adr/0004).
struct SATWidths {
    SATWidths(glm::vec2 sizeTexels) : minTexels(sizeTexels), maxTexels(sizeTexels) {}
    SATWidths(const Image& widthMap, glm::vec2 from, glm::vec2 to) : minTexels(from), maxTexels(to), map(&widthMap) {}

    glm::vec2 minTexels;         // where the map's red is 0
    glm::vec2 maxTexels;         // where it is 1
    const Image* map = nullptr;  // of the result's extent
};

// Holds the pipelines and the result: 16 bytes of device memory per texel. Move-only. Not thread-safe.
class SATFilter {
public:
    // Throws Error: extent is 0 or over the device's limit; a combination that the comments above exclude.
    SATFilter(Device& device, const SATFilterDesc& desc);

    // Returns the filtered image, RGBA32F in the picture's units, readable by shaders up to the next Record() on the
    // same object. Where a width of the map is too large for exact sums, the texel is NaN.
    //
    //   bias  the one that was taken off when the table was built. FP32 only
    //
    // Throws Error: one width, and it is too large for exact sums; the line names the largest that is not.
    //
    // Cost a texel, in loads a word: boxes 16, of odd whole width in integers 4; tent 9, parabolic of odd width 16;
    // tents of other widths 121, parabolic ones 361.
    const Image& Record(CommandList& commands, TexelWords table, const SATWidths& widths,
                        const Image* bias = nullptr);

private:
    const Pipeline& PipelineFor(bool whole);

    Device& m_device;
    SATFilterDesc m_desc;
    std::map<bool, Pipeline> m_pipelines;  // by whether the width is whole
    Image m_zero;                          // one texel: no map, no bias
    Image m_result;
};

}  // namespace boxcar
