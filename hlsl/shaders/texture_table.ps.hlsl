// texture_table.ps: a texture as its summed-area table filters it: the mean over the upright rectangle that holds the
// pixel, over as many repetitions as it reaches.
// Crow 1984, sect. 2.3 (the rectangle) and 2.4 (repeated textures)
#include "boxcar/footprint.hlsli"
#include "boxcar/sat_exact.hlsli"
#include "shaders/textured.hlsli"

Texture2D<uint4> table : register(t0);

// Boxes of 8 x 8 repetitions of TEXTURE_SIDE_TEXELS and TEXTURE_WHITE_CODES fit into 32 bits. Wider ones have the same
// mean.
static const float kMostRepeats = 8.0;

float4 main(SceneVertex i) : SV_Target0
{
    int2 extentTexels;
    table.GetDimensions(extentTexels.x, extentTexels.y);
    float2 uv = TexturedUv(i);
    float2 sizeUv = clamp(FootprintRectangle(ddx(uv), ddy(uv)), 1.0 / float2(extentTexels), kMostRepeats);
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_REPEAT);
    SATBox box = SATClipBox(frame, SATBoxAt(TexelUvToEdge(uv, extentTexels), TexelUvToEdge(sizeUv, extentTexels)));
    return TexturedLight(i, SATSumBox(SATTable32(table), frame, box) / (SATBoxArea(box) * float(TEXTURE_WHITE_CODES)));
}
