// Fits a stack of boxes to a lobe of reflected light.
//
//   lobe on a paraboloid's disc  ->  half-widths and weights of k nested squares, of least error
//
// A lobe round the mirror direction is drawn on the disc of a paraboloid whose axis is that direction (place tan(t /
// 2) for the angle t); there it is as dense as its light times the sphere's area per area of the disc.
//
// Hensley 2005, sect. 5.1.2 and 7 (future work)
#pragma once

#include <functional>
#include <vector>

namespace boxcar {

// Light per area of the disc at a distance rho from its middle, 0 to 1; need not add up to 1.
using Lobe = std::function<double(double rho)>;

// cos^n of the angle from the mirror direction.
Lobe PhongLobe(double exponent);

// The GGX distribution of half vectors, seen from above: alpha is the square of artists' roughness. On the disc it is
// alpha^2 / (pi (alpha^2 + rho^2)^2): its tails are long.
//
// Walter 2007, eq. 33
Lobe GgxLobe(double alpha);

struct BoxStackFit {
    std::vector<double> halfWidths;  // in the disc's radius, from the inside
    std::vector<double> weights;     // of each box's mean; add up to 1
    double relativeError = 0;        // L2 distance of lobe and stack over the disc, over the lobe's L2 norm
};

// The best stack of `boxes` (1 to 6) nested centred squares whose weights add up to 1. Deterministic. Throws Error:
// the lobe is 0 everywhere or not finite.
//
// Cost: some milliseconds.
BoxStackFit FitBoxStack(const Lobe& lobe, int boxes);

}  // namespace boxcar
