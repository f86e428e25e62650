#include "samples/effects/lobe_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSteps = 20000;  // of the integrals along the radius
constexpr int kAngles = 48;    // of those over a square

// Integrals of a lobe over discs and squares round the middle.
class LobeIntegrals {
public:
    explicit LobeIntegrals(const Lobe& lobe) {
        // Simpson's rule from each radius to the next.
        m_disc.push_back(0);
        for (int i = 0; i < kSteps; i++) {
            const double from = Radius(i), to = Radius(i + 1), middle = 0.5 * (from + to);
            const double step = (to - from) / 6;
            const std::array g = {lobe(from), lobe(middle), lobe(to)};
            m_disc.push_back(m_disc.back() + step * 2 * kPi * (from * g[0] + 4 * middle * g[1] + to * g[2]));
            m_squared += step * 2 * kPi * (from * g[0] * g[0] + 4 * middle * g[1] * g[1] + to * g[2] * g[2]);
        }
        if (!(m_disc.back() > 0) || !std::isfinite(m_disc.back()) || !std::isfinite(m_squared))
            throw Error("a lobe of no light, or of no end of it");
    }

    // Of a lobe that adds up to 1.
    double Disc(double radius) const {
        const double at = std::sqrt(std::min(radius, 1.0)) * kSteps;
        const int i = std::min(static_cast<int>(at), kSteps - 1);
        const auto k = static_cast<size_t>(i);
        return (m_disc[k] + (at - i) * (m_disc[k + 1] - m_disc[k])) / m_disc.back();
    }
    double Squared() const { return m_squared / (m_disc.back() * m_disc.back()); }

    // Over the square of this half-width: eight triangles, each the mean of discs' sectors.
    double Square(double halfWidth) const {
        double sum = 0;
        for (int i = 0; i < kAngles; i++)
            sum += Disc(halfWidth / std::cos((i + 0.5) / kAngles * kPi / 4));
        return sum / kAngles;
    }

    // The radius within which half of the light lies.
    double MedianRadius() const {
        const auto half = std::ranges::lower_bound(m_disc, m_disc.back() / 2);
        return Radius(static_cast<int>(half - m_disc.begin()));
    }

private:
    // Denser towards the middle, where narrow lobes are.
    static double Radius(int i) { return std::pow(static_cast<double>(i) / kSteps, 2); }

    std::vector<double> m_disc;  // up to each radius
    double m_squared = 0;
};

// Solves a x = b by elimination; `a` by rows. Zeros where it has no answer.
std::vector<double> Solve(std::vector<std::vector<double>> a, std::vector<double> b) {
    const size_t n = b.size();
    for (size_t column = 0; column < n; column++) {
        size_t pivot = column;
        for (size_t row = column; row < n; row++)
            if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
        if (std::abs(a[pivot][column]) < 1e-300) return std::vector<double>(n, 0);
        std::swap(a[pivot], a[column]);
        std::swap(b[pivot], b[column]);
        for (size_t row = 0; row < n; row++) {
            if (row == column) continue;
            const double factor = a[row][column] / a[column][column];
            for (size_t k = column; k < n; k++)
                a[row][k] -= factor * a[column][k];
            b[row] -= factor * b[column];
        }
    }
    for (size_t i = 0; i < n; i++)
        b[i] /= a[i][i];
    return b;
}

// The best weights for squares of these half-widths. With w the weights of means: the squared distance is
// |lobe|^2 - 2 sum w_i S_i / area_i + sum w_i w_j / max(area_i, area_j), least under sum w = 1 (Lagrange).
BoxStackFit WithWeights(const LobeIntegrals& lobe, std::vector<double> halfWidths) {
    std::ranges::sort(halfWidths);
    const size_t n = halfWidths.size();
    std::vector a(n + 1, std::vector<double>(n + 1, 0));
    std::vector<double> b(n + 1, 1);
    for (size_t i = 0; i < n; i++) {
        b[i] = lobe.Square(halfWidths[i]) / (4 * halfWidths[i] * halfWidths[i]);
        for (size_t j = 0; j < n; j++)
            a[i][j] = 1 / (4 * std::pow(std::max(halfWidths[i], halfWidths[j]), 2));
        a[i][n] = a[n][i] = 1;
    }
    std::vector<double> weights = Solve(a, b);
    weights.resize(n);
    double squared = lobe.Squared();
    for (size_t i = 0; i < n; i++) {
        squared -= 2 * weights[i] * b[i];
        for (size_t j = 0; j < n; j++)
            squared += weights[i] * weights[j] * a[i][j];
    }
    return {halfWidths, weights, std::sqrt(std::max(squared, 0.0) / lobe.Squared())};
}

using Point = std::vector<double>;

// Nelder and Mead's simplex, from `start`.
Point Minimum(const std::function<double(const Point&)>& f, const Point& start) {
    struct Corner {
        Point at;
        double value;
    };
    std::vector<Corner> simplex = {{start, f(start)}};
    for (size_t i = 0; i < start.size(); i++) {
        Point at = start;
        at[i] += 0.1;
        simplex.push_back({at, f(at)});
    }
    const auto between = [](const Point& a, const Point& b, double t) {
        Point p = a;
        for (size_t i = 0; i < p.size(); i++)
            p[i] += t * (b[i] - a[i]);
        return p;
    };
    for (int step = 0; step < 1500; step++) {
        std::ranges::sort(simplex, {}, &Corner::value);
        Corner& worst = simplex.back();
        if (worst.value - simplex[0].value < 1e-14) break;
        Point middle(start.size(), 0);
        for (size_t i = 0; i + 1 < simplex.size(); i++)
            for (size_t k = 0; k < middle.size(); k++)
                middle[k] += simplex[i].at[k] / static_cast<double>(start.size());
        const auto corner = [&](double t) {
            const Point at = between(middle, worst.at, t);
            return Corner{at, f(at)};
        };
        const Corner reflected = corner(-1);
        if (reflected.value < simplex[0].value) {
            const Corner further = corner(-2);
            worst = further.value < reflected.value ? further : reflected;
        } else if (reflected.value < simplex[simplex.size() - 2].value) {
            worst = reflected;
        } else {
            const Corner nearer = corner(reflected.value < worst.value ? -0.5 : 0.5);
            if (nearer.value < std::min(worst.value, reflected.value)) {
                worst = nearer;
            } else {
                for (size_t i = 1; i < simplex.size(); i++) {
                    simplex[i].at = between(simplex[0].at, simplex[i].at, 0.5);
                    simplex[i].value = f(simplex[i].at);
                }
            }
        }
    }
    return std::ranges::min_element(simplex, {}, &Corner::value)->at;
}

}  // namespace

Lobe PhongLobe(double exponent) {
    return [exponent](double rho) {
        const double s = rho * rho;
        return std::pow(std::max(0.0, (1 - s) / (1 + s)), exponent);
    };
}

Lobe GgxLobe(double alpha) {
    return [squared = alpha * alpha](double rho) {
        return squared * std::pow((1 + rho * rho) / (squared + rho * rho), 2) / kPi;
    };
}

BoxStackFit FitBoxStack(const Lobe& lobe, int boxes) {
    BOXCAR_ASSERT(boxes >= 1 && boxes <= 6);
    const LobeIntegrals integrals(lobe);
    // Logarithms of the half-widths: all of them stay above 0.
    const auto fitOf = [&](const Point& logarithms) {
        std::vector<double> halfWidths;
        for (const double logarithm : logarithms)
            halfWidths.push_back(std::exp(logarithm));
        return WithWeights(integrals, halfWidths);
    };
    BoxStackFit best;
    best.relativeError = INFINITY;
    for (const double spread : {1.6, 3.0, 6.0}) {
        Point start;
        for (int i = 0; i < boxes; i++) {
            const double share = boxes > 1 ? static_cast<double>(i) / (boxes - 1) - 0.4 : 0.3;
            start.push_back(std::log(integrals.MedianRadius() * std::pow(spread, 1.5 * share)));
        }
        const Point at = Minimum([&](const Point& p) { return fitOf(p).relativeError; }, start);
        const BoxStackFit fit = fitOf(at);
        if (fit.relativeError < best.relativeError) best = fit;
    }
    return best;
}

}  // namespace boxcar
