#include "chapters/02_collision_detection/cubic_roots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {
namespace {

RealRoots quadratic_roots(double c0, double c1, double c2)
{
    const double discriminant = c1 * c1 - 4 * c2 * c0;
    if (discriminant < 0)
        return {};
    // The root whose numerator does not cancel, and the other from the product of both.
    const double q = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
    if (q == 0)
        return {{0.0}, 1};
    const double root = q / c2, other = c0 / q;
    return {{std::min(root, other), std::max(root, other)}, 2};
}

/// Roots of t^3 + a t^2 + b t + c.
RealRoots monic_cubic_roots(double a, double b, double c)
{
    const double shift = a / 3, p = (a * a - 3 * b) / 9, q = (a * (2 * a * a - 9 * b) + 27 * c) / 54;
    if (q * q < p * p * p) {  // three roots, in this order ascending: angle lies in [0, pi/3]
        const double angle = std::acos(std::clamp(q / std::sqrt(p * p * p), -1.0, 1.0)) / 3,
                     radius = -2 * std::sqrt(p);
        const double turn = 2 * std::numbers::pi / 3;
        return {{radius * std::cos(angle) - shift, radius * std::cos(angle - turn) - shift,
                 radius * std::cos(angle + turn) - shift},
                3};
    }
    const double u = -std::copysign(std::cbrt(std::abs(q) + std::sqrt(q * q - p * p * p)), q);
    return {{u + (u == 0 ? 0 : p / u) - shift}, 1};
}

}  // namespace

RealRoots cubic_roots(const std::array<double, 4>& c, double zero)
{
    const double negligible = zero *
                              std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2]), std::abs(c[3])});
    if (std::abs(c[3]) > negligible)
        return monic_cubic_roots(c[2] / c[3], c[1] / c[3], c[0] / c[3]);
    if (std::abs(c[2]) > negligible)
        return quadratic_roots(c[0], c[1], c[2]);
    if (std::abs(c[1]) > negligible)
        return {{-c[0] / c[1]}, 1};
    return {};
}

}  // namespace enduring
