// dual_paraboloid_sat.hlsli: light from a cone of directions, from the summed-area tables of two faces.
//
// Tables hold colour times weight, and the weight itself in alpha (DPWeight): sums of both faces are added, and one division
// by the summed weight ends it. Tables of integers (sat_exact.hlsli) count the weights exactly, so that a constant
// environment stays constant at every width, over the seam too (DualParaboloid.AConstantEnvironmentStaysConstant).
//
//   DPSampleSAT            one box, round the cone
//   DPSampleSATStack       boxes one inside the other, for a lobe
//   DPSampleSATOrder       a tent or a parabolic kernel, from tables of order 2 or 3
//   DPSampleSATOrderFine   the same with tables of what rounding left over, for lamps in the dark
//   DPSampleSATFixed       as the papers have it: floats, one width in texels all over the faces
//
// Hensley 2005, sect. 5.1; Scheuermann 2005 (texDP_SAT)
#ifndef BOXCAR_DUAL_PARABOLOID_SAT_HLSLI
#define BOXCAR_DUAL_PARABOLOID_SAT_HLSLI

#include "boxcar/box_stack.hlsli"
#include "boxcar/dual_paraboloid.hlsli"
#include "boxcar/sat_order.hlsli"

// The tables of both faces: integers, colour codes in rgb, weight codes in alpha.
struct DPTables
{
    SATExactTable front;
    SATExactTable back;
    int sideTexels;     // of a face
    int largestTexels;  // width of boxes whose kernel of the tables' order the words hold; odd for order 3
    float codeScale;    // colour codes of light 1 and weight code 1
};

// DPTablesOf: as DualParaboloidTables builds them, two words a channel.
DPTables DPTablesOf(Texture2D<uint4> frontLow, Texture2D<uint4> frontHigh, Texture2D<uint4> backLow,
                    Texture2D<uint4> backHigh, int largestTexels, float codeScale)
{
    DPTables tables;
    tables.front = SATTable64(frontLow, frontHigh, false);
    tables.back = SATTable64(backLow, backHigh, false);
    int heightTexels;
    frontLow.GetDimensions(tables.sideTexels, heightTexels);
    tables.largestTexels = largestTexels;
    tables.codeScale = codeScale;
    return tables;
}

// DPFineTablesOf: what rounding left over in `tables`, kDPFineScale times as fine; two's complement.
DPTables DPFineTablesOf(DPTables tables, Texture2D<uint4> frontLow, Texture2D<uint4> frontHigh,
                        Texture2D<uint4> backLow, Texture2D<uint4> backHigh)
{
    DPTables fine = tables;
    fine.front = SATTable64(frontLow, frontHigh, true);
    fine.back = SATTable64(backLow, backHigh, true);
    return fine;
}

float4 DPSumBox(SATExactTable table, DPCircle circle, int sideTexels)
{
    SATFrame frame = SATFrameAtCorner(int2(sideTexels, sideTexels), SAT_EDGE_CLIP);
    SATBox box = DPBoxOf(circle, sideTexels);
    // One texel at least, and so at the pole of a cone without width.
    float2 centre = 0.5 * (box.loTexels + box.hiTexels);
    float2 size = max(box.hiTexels - box.loTexels, 1.0);
    return SATSumBox(table, frame, SATClipBox(frame, SATBoxAt(centre, size)));
}

// DPSumCone: light and weight over the box round a cone, both faces together. A face that none of it is on is not read.
//
//   dir         length 1
//   sizeTexels  width of the cone at a face's middle; less than 1 is taken as 1
//   returns     codes: rgb of light times weight, alpha of weight
//
// Cost: 16 loads a word and face.
float4 DPSumCone(DPTables tables, float3 dir, float sizeTexels)
{
    float radius = max(sizeTexels, 1.0) / tables.sideTexels;
    DPCircle front = DPCircleOf(dir, DP_FRONT, radius);
    DPCircle back = DPCircleOf(dir, DP_BACK, radius);
    float4 sum = (float4)0;
    if (DPIsSeen(front))
        sum += DPSumBox(tables.front, front, tables.sideTexels);
    if (DPIsSeen(back))
        sum += DPSumBox(tables.back, back, tables.sideTexels);
    return sum;
}

// DPSampleSAT: mean light over the box round a cone. The papers' texDP_SAT, with a width that is the same on the sphere,
// not on the faces, and texels weighted by their solid angle.
//
//   dir         length 1
//   sizeTexels  width of the cone at a face's middle: tan(t / 2) * sideTexels for a half angle t; 1 at least, and at the most
//               0.414 * sideTexels (45 degrees)
//   returns     light; alpha 1
//
// Cost: 16 loads a word and face.
float4 DPSampleSAT(DPTables tables, float3 dir, float sizeTexels)
{
    float4 sum = DPSumCone(tables, dir, sizeTexels);
    return float4(sum.rgb / (tables.codeScale * sum.a), 1.0);
}

// DPSampleSATStack: light under a lobe, as a stack of boxes.
//
//   sigmaTexels  of the Gaussian that the lobe is at a face's middle: BoxStackSigma(n) * sideTexels / 2 for cos^n
//   boxes        1 to 6
//
// Range: n of 7 and more; boxes of wider lobes are cut at 45 degrees: cos^1 would be off by 79 %.
// Error: of the light under cos^n for 4 boxes, relative L2: 6 % over environments without small lamps, n from 10 to 200; over
//        nothing but two lamps 27 % (DualParaboloid.LobesAreWithinTheirBoundsOfTheIntegralOverRealEnvironments).
// Cost:  16 loads a box, word and face.
float4 DPSampleSATStack(DPTables tables, float3 dir, float sigmaTexels, int boxes)
{
    float3 light = (float3)0;
    [loop]
    for (int i = 0; i < boxes; i++)
    {
        float2 box = BoxStack(boxes, i);
        float4 sum = DPSumCone(tables, dir, 2.0 * box.x * sigmaTexels);
        light += box.y * sum.rgb / sum.a;
    }
    return float4(light / tables.codeScale, 1.0);
}

// DPSumOrder: one face under a kernel of boxes of a whole width, at any centre: the kernels at the four texels round it,
// blended.
float4 DPSumOrder(SATExactTable table, int sideTexels, int order, float2 centreTexels, int widthTexels)
{
    int2 extent = int2(sideTexels, sideTexels);
    float2 at = centreTexels - 0.5;
    int2 first = int2(floor(at));
    float2 share = at - floor(at);
    float4 sum = (float4)0;
    [loop]
    for (int i = 0; i < 4; i++)
    {
        int2 corner = int2(i & 1, i >> 1);
        float2 weights = float2(corner.x == 1 ? share.x : 1.0 - share.x, corner.y == 1 ? share.y : 1.0 - share.y);
        SATWide kernel = SATSumWhole(table, extent, order, first + corner, int2(widthTexels, widthTexels));
        sum += weights.x * weights.y * SATWideToFloat(kernel, table.words, table.isSigned);
    }
    return sum;
}

float4 DPSumOrderFace(SATExactTable table, int face, DPTables tables, int order, float3 dir, float widthTexels)
{
    int sideTexels = tables.sideTexels;
    // The circle that sets the kernel's middle and scale: of 1.75 sigma on the near face. On the far face it grows into that
    // of the kernel's reach, so that the kernel comes over the rim from nothing.
    float sigma = 2.0 * widthTexels / (sideTexels * (order == 2 ? kDPTentOverSigma : kDPParabolicOverSigma));
    float reach = min(order * widthTexels / sideTexels, kDPLargestRadius);
    float comingCosine = -2.0 * reach / (1.0 + reach * reach);
    float farShare = saturate(DPAxisCosine(dir, face) / comingCosine);
    float radius = lerp(min(1.75 * sigma, reach), reach, farShare);
    DPCircle circle = DPCircleOf(dir, face, radius);
    float4 sum = (float4)0;
    if (DPIsSeen(DPCircleOf(dir, face, reach)))
    {
        float width = widthTexels * circle.radius / radius;
        int whole = order == 2 ? int(max(1.0, floor(width + 0.5))) : 2 * int(max(0.0, floor(0.5 * width))) + 1;
        whole = min(whole, tables.largestTexels);
        // The kernels of both faces are made as high in the middle, however wide they are.
        float square = float(whole) * float(whole);
        sum = DPSumOrder(table, sideTexels, order, DPDiscToUv(circle.centre) * sideTexels, whole)
            / (order == 2 ? square : square * square);
    }
    return sum;
}

// DPSumOrderFaces: both faces.
float4 DPSumOrderFaces(DPTables tables, int order, float3 dir, float widthTexels)
{
    return DPSumOrderFace(tables.front, DP_FRONT, tables, order, dir, widthTexels)
         + DPSumOrderFace(tables.back, DP_BACK, tables, order, dir, widthTexels);
}

// DPSampleSATOrder: light under a tent or a parabolic kernel.
//
//   order        2: tent, 3: parabolic; of the tables
//   widthTexels  of the boxes that the kernel is made of, at a face's middle: kDPTentOverSigma, kDPParabolicOverSigma
//
// Error: as of DPSampleSATStack: tents 5 %, lamps 36 %; parabolic kernels 6 %, lamps 34 %, both at the rim for n = 10; in the
//        middle of a face 1 to 2 %.
// Cost:  36 or 64 loads a word and face.
float4 DPSampleSATOrder(DPTables tables, int order, float3 dir, float widthTexels)
{
    float4 sum = DPSumOrderFaces(tables, order, dir, widthTexels);
    return float4(sum.rgb / (tables.codeScale * sum.a), 1.0);
}

// DPSampleSATOrderFine: DPSampleSATOrder where a code of the tables is too coarse for the dark beside a lamp.
//
// Error: beyond that of DPSampleSATOrder, of light of 0.02 beside a lamp of 10^6: 2e-4
//        (DualParaboloid.TheDarkBesideALampIsRight).
//
//   fine  DPFineTablesOf(tables, ..)
//
// Cost:  72 or 128 loads a word and face.
float4 DPSampleSATOrderFine(DPTables tables, DPTables fine, int order, float3 dir, float widthTexels)
{
    float4 sum = DPSumOrderFaces(tables, order, dir, widthTexels);
    float3 rest = DPSumOrderFaces(fine, order, dir, widthTexels).rgb / kDPFineScale;
    return float4((sum.rgb + rest) / (tables.codeScale * sum.a), 1.0);
}

// DPSampleSATFixed: the papers' texDP_SAT, with the division that the summed alpha is for: one width in texels everywhere
// on the faces, so cones become narrower on the sphere towards the rim, and every texel counts as much.
//
//   frontTable, backTable  tables of floats: colour in rgb, 1 in alpha, both 0 outside of the disc
//   extentTexels           of a face
//
// Error: of a constant on faces of 256 texels 1.4 % at width 1, 0.09 % at 3, 0.004 % at 17: alpha counts whole texels, but
//        colours are rounded (DualParaboloid.ThePapersLookupKeepsAConstantWithinItsBound).
// Cost:  16 loads a face.
float4 DPSampleSATFixed(Texture2D<float4> frontTable, Texture2D<float4> backTable, int2 extentTexels, float3 dir,
                        float sizeTexels)
{
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_CLIP);
    float2 size = float2(max(sizeTexels, 1.0), max(sizeTexels, 1.0));
    float4 sum = (float4)0;
    if (DPAxisCosine(dir, DP_FRONT) > -0.999)
        sum += SATSumBox(frontTable, frame, SATClipBox(frame, SATBoxAt(DPDirectionToUv(dir, DP_FRONT) * extentTexels, size)));
    if (DPAxisCosine(dir, DP_BACK) > -0.999)
        sum += SATSumBox(backTable, frame, SATClipBox(frame, SATBoxAt(DPDirectionToUv(dir, DP_BACK) * extentTexels, size)));
    return float4(sum.rgb / max(sum.a, 1e-6), 1.0);
}

#endif
