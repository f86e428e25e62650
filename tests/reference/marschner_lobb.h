// The test signal of Marschner and Lobb with its derivatives, in double: waves about the z axis whose frequency grows
// with the distance, on a sine along z.
//
// Marschner and Lobb 1994, sect. 5
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace boxcar::reference {

struct MarschnerLobb {
    static constexpr double kPi = 3.14159265358979323846, kAlpha = 0.25, kFrequency = 6;

    double value;
    glm::dvec3 gradient;
    glm::dmat3 hessian;

    // 0 to 1; p within (-1, 1) on every axis, off the z axis.
    explicit MarschnerLobb(glm::dvec3 p) {
        const double r = std::hypot(p.x, p.y), c = 1 / (2 * (1 + kAlpha));
        // w(r) = cos(a(r)), a = 2 pi f cos(pi r / 2)
        const double a = 2 * kPi * kFrequency * std::cos(kPi * r / 2);
        const double a1 = -kPi * kPi * kFrequency * std::sin(kPi * r / 2);
        const double a2 = -kPi * kPi * kPi / 2 * kFrequency * std::cos(kPi * r / 2);
        const double w = std::cos(a), w1 = -std::sin(a) * a1, w2 = -std::cos(a) * a1 * a1 - std::sin(a) * a2;
        value = c * (1 - std::sin(kPi * p.z / 2) + kAlpha * (1 + w));
        const double ux = p.x / r, uy = p.y / r;
        const double along = c * kAlpha * w1, across = along / r, second = c * kAlpha * w2;
        gradient = {along * ux, along * uy, -c * kPi / 2 * std::cos(kPi * p.z / 2)};
        const double xy = (second - across) * ux * uy;
        hessian = glm::dmat3(second * ux * ux + across * uy * uy, xy, 0,  //
                             xy, second * uy * uy + across * ux * ux, 0,  //
                             0, 0, c * kPi * kPi / 4 * std::sin(kPi * p.z / 2));
    }
};

}  // namespace boxcar::reference
