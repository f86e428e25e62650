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

// SATAxisMass: the most that a row of ones adds up to in any integer that the filter of an order makes on one axis.
//
//   order        1 box, 2 tent, 3 parabolic
//   widthTexels  of the box that the kernel is made of; 1 at least
//
// Whole widths of boxes and tents, and odd ones of parabolic filters, take widthTexels^order. Others read entries that
// are summed from the middle of the kernel outwards (sat_order.hlsli): K (K + 1) / 2 and K (K + 1) (K + 2) / 6 for
// entries K texels away, and one bit for their sign, half of it on either axis.
SAT_INLINE float SATAxisMass(float widthTexels, int order)
{
    float whole = ceil(widthTexels);
    if (order == 1)
        return whole;
    float mass = order == 2 ? whole * whole : whole * whole * whole;
    bool isWhole = whole == widthTexels && (order == 2 || whole - 2.0f * ceil(0.5f * whole - 0.5f) == 1.0f);
    if (isWhole)
        return mass;
    float reach = order == 2 ? whole + 2.0f : 2.0f * whole + 3.0f;
    float entry = order == 2 ? reach * (reach + 1.0f) / 2.0f : reach * (reach + 1.0f) * (reach + 2.0f) / 6.0f;
    return max(mass, 1.41421366f * entry);
}

// SATBoxIsExact: whether an exact table is sure to hold the sum under a filter.
//
//   sizeTexels   width and height of the box that the kernel is made of; less than 1 is taken as 1
//   order        1 box, 2 tent, 3 parabolic
//   largestMass  (2^32 - 1) / largest code for one word, (2^64 - 1) / largest code for two; half of it where codes
//                may be negative
//
// Never true where the sum may overflow. False up to 5e-7 below the bound, which leaves a margin for float's rounding.
SAT_INLINE bool SATBoxIsExact(float2 sizeTexels, int order, float largestMass)
{
    float mass = SATAxisMass(max(sizeTexels.x, 1.0f), order) * SATAxisMass(max(sizeTexels.y, 1.0f), order);
    return mass * 1.0000005f <= largestMass;
}

#ifdef __cplusplus
#undef SAT_INLINE
}  // namespace boxcar
#endif

#endif
