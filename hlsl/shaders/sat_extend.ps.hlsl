// sat_extend.ps: a picture of codes with as much of its surroundings as a kernel reaches, where it is repeated.
#include "boxcar/compat.hlsli"
#include "boxcar/texel.hlsli"
#include "constants/sat_constants.h"
#include "shaders/quad_io.hlsli"
#include "shaders/words_io.hlsli"

BOXCAR_CONSTANTS(Constants) { SATExtendConstants g; };
Texture2D<uint4> source : register(t0);
#if WORDS == 2
Texture2D<uint4> sourceHigh : register(t1);
#endif

int Wrap(int texel, int sizeTexels)
{
    int periodTexels = g.isMirrored != 0 ? 2 * sizeTexels : sizeTexels;
    int periods = texel >= 0 ? texel / periodTexels : -((periodTexels - 1 - texel) / periodTexels);
    int offset = texel - periods * periodTexels;
    return offset < sizeTexels ? offset : 2 * sizeTexels - 1 - offset;
}

WordsTarget main(QuadVertex i)
{
    int2 texel = TexelFromEdge(i.position.xy) - g.paddingTexels;
    int3 at = int3(Wrap(texel.x, g.extentTexels.x), Wrap(texel.y, g.extentTexels.y), 0);
#if WORDS == 2
    return WordsTargetOf(SATWideOf(source.Load(at), sourceHigh.Load(at)));
#else
    return WordsTargetOf(SATWideOf(source.Load(at), uint4(0u, 0u, 0u, 0u)));
#endif
}
