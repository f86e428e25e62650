// words_io.hlsli: integers modulo 2^32 or 2^64 as textures and targets. WORDS is set on the compiler's command line: 1,
// or 2 for a lower and an upper word in textures of their own.
#ifndef BOXCAR_WORDS_IO_HLSLI
#define BOXCAR_WORDS_IO_HLSLI

#include "boxcar/sat_exact.hlsli"

struct WordsTarget
{
    uint4 low : SV_Target0;
#if WORDS == 2
    uint4 high : SV_Target1;
#endif
};

WordsTarget WordsTargetOf(SATWide value)
{
    WordsTarget o;
    o.low = value.low;
#if WORDS == 2
    o.high = value.high;
#endif
    return o;
}

#endif
