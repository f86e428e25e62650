// Fits a stack of boxes to a lobe of reflected light.
//
//   lobe on a paraboloid's disc  ->  half-widths and weights of k nested squares, of least error
//
// A lobe round the mirror direction is drawn on the disc of a paraboloid whose axis is that direction: at tan(t / 2)
// for the angle t. It is fitted there, as tables sum that weigh each texel by its solid angle (DPWeight).
//
// Hensley 2005, sect. 5.1.2 and 7 (future work)
#pragma once

#include <functional>
#include <vector>

namespace boxcar {

// Light per solid angle at a distance rho from the disc's middle, 0 to 1; need not add up to 1.
using Lobe = std::function<double(double rho)>;

// cos^n of the angle from the mirror direction.
Lobe PhongLobe(double exponent);

// The GGX distribution of half vectors, seen from above: alpha is the square of artists' roughness. rho is the
// tangent of the half vector's angle; the lobe goes as ((1 + rho^2) / (alpha^2 + rho^2))^2: its tails are long.
//
// Walter 2007, eq. 33
Lobe GgxLobe(double alpha);

struct BoxStackFit {
    std::vector<double> halfWidths;  // in the disc's radius, from the inside
    std::vector<double> weights;     // of each box's mean; add up to 1
    double relativeError = 0;        // L2 distance of lobe and stack over the disc, over the lobe's L2 norm
};

// The best stack of `boxes` (1 to 6) nested centered squares whose weights add up to 1. Deterministic. Throws Error:
// the lobe is 0 everywhere or not finite.
//
// Cost: some milliseconds.
BoxStackFit FitBoxStack(const Lobe& lobe, int boxes);

}  // namespace boxcar
