// precision_round.hlsli: numbers of fewer bits, made of float32 by rounding its bits.
//
//   Round16      IEEE half: 1-5-10, bias 15, subnormals, to the nearest, ties to even
//   Round24      ATI's 24 bits: 1-7-16, bias 63, to the nearest, ties to even
//   Truncate24   the same, towards 0
//
// A rounding of its own, because neither Direct3D nor Vulkan says how a render target rounds what is written to it: a
// value of Round16 is stored in a half as it is. The 24 bits have no subnormals: what is below 2^-62 after rounding is
// 0 of its sign. Beyond the largest finite value lies infinity, as in IEEE; truncation stops at that value. NaN stays
// NaN.
#ifndef BOXCAR_PRECISION_ROUND_HLSLI
#define BOXCAR_PRECISION_ROUND_HLSLI

static const uint kSignBit = 0x80000000u;
static const uint kInfinityBits = 0x7f800000u;

// Drops the lowest bits of a magnitude, to the nearest, ties to even. A carry out of the mantissa raises the exponent,
// as it should.
uint PrecisionDropBits(uint magnitude, uint droppedBits)
{
    uint odd = (magnitude >> droppedBits) & 1u;
    uint justUnderHalf = (1u << (droppedBits - 1u)) - 1u;
    return ((magnitude + justUnderHalf + odd) >> droppedBits) << droppedBits;
}

// Below 2^-14 a half is a whole multiple of 2^-24.
uint PrecisionSubnormalHalf(uint magnitude)
{
    uint droppedBits = 126u - (magnitude >> 23);  // 14 just below 2^-14
    if (droppedBits > 25u)
        return 0u;  // less than half of 2^-24
    uint significand = (magnitude & 0x007fffffu) | 0x00800000u;
    uint multiple = PrecisionDropBits(significand, droppedBits) >> droppedBits;
    return asuint(float(multiple) * asfloat(103u << 23));  // 2^-24
}

float PrecisionRound16(float value)
{
    uint bits = asuint(value);
    uint magnitude = bits & ~kSignBit;
    uint rounded = magnitude;
    if (magnitude < kInfinityBits)
    {
        rounded = magnitude < (113u << 23) ? PrecisionSubnormalHalf(magnitude) : PrecisionDropBits(magnitude, 13u);
        if (rounded >= (143u << 23))  // 2^16
            rounded = kInfinityBits;
    }
    return asfloat((bits & kSignBit) | rounded);
}

float PrecisionRound24(float value, bool truncated)
{
    uint bits = asuint(value);
    uint magnitude = bits & ~kSignBit;
    uint rounded = magnitude;
    if (magnitude < kInfinityBits)
    {
        rounded = truncated ? (magnitude >> 7) << 7 : PrecisionDropBits(magnitude, 7u);
        if (rounded < (65u << 23))  // 2^-62
            rounded = 0u;
        if (rounded >= (191u << 23))  // 2^64
            rounded = truncated ? (191u << 23) - (1u << 7) : kInfinityBits;
    }
    return asfloat((bits & kSignBit) | rounded);
}

float4 Round16(float4 v)
{
    return float4(PrecisionRound16(v.x), PrecisionRound16(v.y), PrecisionRound16(v.z), PrecisionRound16(v.w));
}

float4 Round24(float4 v)
{
    return float4(PrecisionRound24(v.x, false), PrecisionRound24(v.y, false), PrecisionRound24(v.z, false),
                  PrecisionRound24(v.w, false));
}

float4 Truncate24(float4 v)
{
    return float4(PrecisionRound24(v.x, true), PrecisionRound24(v.y, true), PrecisionRound24(v.z, true),
                  PrecisionRound24(v.w, true));
}

#endif
