// dual_paraboloid_range.h: how wide the kernels on the faces of a dual paraboloid get, and how finely their tables can
// count light. One text for HLSL and C++.
//
// Under a kernel of boxes of w texels a sum is up to w^(2 order) times the largest code: the widest box that can occur
// leaves 63 - 2 order log2 w bits to a code. Where these are too few for a lamp and the dark beside it, a second table
// holds what rounding leaves over, kDPFineScale times as fine; filters are linear, so the sum of both is right.
#ifndef BOXCAR_DUAL_PARABOLOID_RANGE_H
#define BOXCAR_DUAL_PARABOLOID_RANGE_H

#ifdef __cplusplus
#include <algorithm>
#include <cmath>
namespace boxcar {
using std::ceil;
using std::min;
#define DP_INLINE inline
#else
#define DP_INLINE
#endif

// Width of a box, and of the boxes of a tent and of a parabolic kernel, over the sigma of the Gaussian they stand for.
static const float kDPBoxOverSigma = 3.274f;
static const float kDPTentOverSigma = 2.316f;
static const float kDPParabolicOverSigma = 1.923f;

static const float kDPLargestRadius = 0.41421356f;  // tan(45 degrees / 2)

// 2^23 codes of a fine table are one of the coarse one; its codes are within 2^22 of 0.
static const float kDPFineScale = 8388608.0f;

// DPWidestBox: the widest box, in whole texels, that DPSampleSATOrder makes a kernel of, anywhere on the faces.
//
//   order        2 tent, 3 parabolic
//   sideTexels   of a face
//   widthTexels  of the boxes at a face's middle
//   returns      at the most sideTexels, and 101 for parabolic kernels, whose sums would leave less than 23 bits; odd for
//                these
//
// A cone that is r at a face's middle is 2 r / ((1 + c) - r^2 (1 - c)) where the cosine from the axis is c, and comes in
// over the rim at c = -2 r / (1 + r^2).
DP_INLINE int DPWidestBox(int order, int sideTexels, float widthTexels)
{
    int most = order == 3 ? min((sideTexels - 1) | 1, 101) : sideTexels;
    float reach = min(float(order) * widthTexels / float(sideTexels), kDPLargestRadius);
    float left = 1.0f - 2.0f * reach - reach * reach;
    if (2.0f * widthTexels >= left * float(most))
        return most;
    int widest = int(ceil(2.0f * widthTexels / left));
    return min(order == 3 ? widest | 1 : widest, most);
}

#ifdef __cplusplus
#undef DP_INLINE
}  // namespace boxcar
#endif

#endif
