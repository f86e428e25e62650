// box_stack.hlsli: boxes of one centre, one inside the other, that stand for a Gaussian.
//
// The lobe cos^n on a paraboloid's disc is very nearly a Gaussian of sigma = 0.5 / sqrt(n) (dual_paraboloid.hlsli).
// Widths and weights are those of least error among all nested stacks whose weights add up to 1; `boxcar fit-lobe` finds
// them for this and for other lobes (LobeFit.TheShadersStacksAreTheBestOnes).
//
// Hensley 2005, sect. 5.1.2 and 7 (the fit is their future work)
#ifndef BOXCAR_BOX_STACK_HLSLI
#define BOXCAR_BOX_STACK_HLSLI

// Half-width of each box in sigma, and the weight of its mean. Relative L2 error of k boxes: 52.9, 33.3, 25.9, 22.1, 20.0,
// 18.6 %.
static const float2 kBoxStacks[21] =
{
    float2(1.637348, 1.000000),
    float2(1.088194, 0.351899), float2(1.942666, 0.648101),
    float2(0.878804, 0.178601), float2(1.402482, 0.348936), float2(2.127731, 0.472463),
    float2(0.758344, 0.108021), float2(1.164699, 0.213654), float2(1.600051, 0.310252),
    float2(2.259895, 0.368072),
    float2(0.677285, 0.072393), float2(1.019914, 0.143847), float2(1.352433, 0.212316),
    float2(1.743630, 0.272136), float2(2.362236, 0.299309),
    float2(0.617858, 0.051906), float2(0.919280, 0.103369), float2(1.196635, 0.153555),
    float2(1.492299, 0.200634), float2(1.855936, 0.239718), float2(2.445471, 0.250818)
};

// BoxStack: half-width in sigma (.x) and weight (.y) of box `index` of `boxes`; 1 <= boxes <= 6, from the inside.
float2 BoxStack(int boxes, int index)
{
    return kBoxStacks[boxes * (boxes - 1) / 2 + index];
}

// BoxStackSigma: standard deviation of the lobe cos^n on a paraboloid's disc, in the disc's units, for sums whose texels are
// weighted by their solid angle (DPWeight). Unweighted sums want n + 1 for n.
//
//   exponent  7 at least for four boxes: those of wider lobes are cut at 45 degrees
float BoxStackSigma(float exponent)
{
    return 0.5 / sqrt(exponent);
}

#endif
