// sat_range.h: how large a filter may be before the words of an exact table overflow. One text for HLSL and C++.
//
// A table of unsigned integers wraps around, and differences undo the wrap: what must fit into a word is the sum under
// the filter itself, however large the table is. That sum is at most the largest code times the kernel's mass, the sum
// of its whole-number weights: w h for a box, (w h)^2 for a tent, (w h)^3 for a parabolic filter.
#ifndef BOXCAR_SAT_RANGE_H
#define BOXCAR_SAT_RANGE_H

#ifdef __cplusplus
#include <algorithm>
#include <cmath>

#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
using std::ceil;
using std::max;
#define SAT_INLINE inline
#else
#define SAT_INLINE
#endif

// SATAxisMass: the most that a row of ones adds up to in any integer that a filter makes on one axis.
//
//   widthTexels  of the box that the kernel is made of; 1 at least
//   order        1 box, 2 tent, 3 parabolic
//   isWhole      SATSumWhole does it: whole widths on both axes. Boxes: no matter
//
// SATSumWhole takes widthTexels^order. SATSumOrder reads entries that are summed from the middle of the kernel outwards:
// K (K + 1) / 2 and K (K + 1) (K + 2) / 6 for entries K texels away, and one bit for their sign, half of it on either
// axis.
SAT_INLINE float SATAxisMass(float widthTexels, int order, bool isWhole)
{
    float whole = ceil(widthTexels);
    if (order == 1)
        return whole;
    if (isWhole)
        return order == 2 ? whole * whole : whole * whole * whole;
    float reach = order == 2 ? whole + 2.0f : 2.0f * whole + 3.0f;
    float entry = order == 2 ? reach * (reach + 1.0f) / 2.0f : reach * (reach + 1.0f) * (reach + 2.0f) / 6.0f;
    return 1.4142137f * entry;
}

// SATBoxIsExact: whether an exact table is sure to hold the sum under a filter.
//
//   sizeTexels   width and height of the box that the kernel is made of; less than 1 is taken as 1
//   order        1 box, 2 tent, 3 parabolic
//   isWhole      SATSumWhole does it: whole widths on both axes. Boxes: no matter
//   largestMass  (2^32 - 1) / largest code for one word, (2^64 - 1) / largest code for two; half of it where codes
//                may be negative
//
// Never true where the sum may overflow, nor for parabolic kernels of boxes over 15,000 texels, whose continued entries
// have weights over 32 bits. False up to 5e-7 below the bound, which leaves a margin for float's rounding.
SAT_INLINE bool SATBoxIsExact(float2 sizeTexels, int order, bool isWhole, float largestMass)
{
    if (order == 3 && max(sizeTexels.x, sizeTexels.y) > 15000.0f)
        return false;
    float mass = SATAxisMass(max(sizeTexels.x, 1.0f), order, isWhole)
               * SATAxisMass(max(sizeTexels.y, 1.0f), order, isWhole);
    return mass * 1.0000005f <= largestMass;
}

#ifdef __cplusplus
#undef SAT_INLINE
}  // namespace boxcar
#endif

#endif
