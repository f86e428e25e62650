// sat_pass_exact.ps: one pass of building a table of integers.
// Hensley 2005, sect. 3; modulo 2^32 or 2^64: beyond the papers
#include "boxcar/compat.hlsli"
#include "boxcar/sat_build.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"
#include "shaders/words_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATPassConstants g; };
Texture2D<uint4> source : register(t0);
#if WORDS == 2
Texture2D<uint4> sourceHigh : register(t1);
#endif

WordsTarget main(QuadVertex i)
{
#if WORDS == 2
    SATExactTable words = SATTable64(source, sourceHigh, false);
#else
    SATExactTable words = SATTable32(source);
#endif
    SATTaps taps = SATTapsOf(TexelFromEdge(i.position.xy), g.originTexels, g.strideTexels);
    return WordsTargetOf(SATPassLoad(words, taps, TAPS));
}
