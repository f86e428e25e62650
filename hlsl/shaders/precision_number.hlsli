// precision_number.hlsli: the arithmetic of a table, chosen by -D PRECISION.
//
//   Number     what a table holds
//   Added      after every addition
//   Stored     before every store
//
//   fp16    a half-float render target under a float32 shader: only a store rounds
//   fp24    ATI's 24 bits in the shader and in the target: every addition rounds
//   fp24t   the same, truncated
//   fp32    float32
//   u32     whole codes modulo 2^32
//
// Hensley 2005, sect. 4.1 (16 and 24-bit floats)
#ifndef BOXCAR_PRECISION_NUMBER_HLSLI
#define BOXCAR_PRECISION_NUMBER_HLSLI

#include "shaders/precision_round.hlsli"

#define fp16 16
#define fp24 24
#define fp24t 25
#define fp32 32
#define u32 33

#if PRECISION == u32
#define Number uint4
#else
#define Number float4
#endif

Number Added(Number sum)
{
#if PRECISION == fp24
    return Round24(sum);
#elif PRECISION == fp24t
    return Truncate24(sum);
#else
    return sum;
#endif
}

Number Stored(Number value)
{
#if PRECISION == fp16
    return Round16(value);
#else
    return Added(value);
#endif
}

#endif
