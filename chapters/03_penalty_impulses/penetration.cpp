#include "chapters/03_penalty_impulses/penetration.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

/// Where a quadratic is zero inside (0, 1), ascending; at most two places.
struct InnerRoots {
    std::array<double, 2> at{};
    int count = 0;
};

/// Roots of slope(tau) = c0 B_0 + c1 B_1 + c2 B_2 by the formula that never subtracts what is nearly equal.
InnerRoots extrema(const Bernstein<double, 2>& slope)
{
    const auto [c0, c1, c2] = slope.coefficients;
    const double square = c0 - 2 * c1 + c2, half_linear = c1 - c0;
    const double discriminant = half_linear * half_linear - square * c0;
    InnerRoots roots;
    if (!(discriminant > 0))
        return roots;
    const double q = -(half_linear + std::copysign(std::sqrt(discriminant), half_linear));
    for (const double candidate : {q / square, c0 / q})
        if (candidate > 0 && candidate < 1)
            roots.at[roots.count++] = candidate;
    if (roots.count == 2 && roots.at[0] > roots.at[1])
        std::swap(roots.at[0], roots.at[1]);
    return roots;
}

/// The root of a monotone piece whose ends differ in sign: Newton's
/// method, kept inside a bracket that shrinks.
double root_between(const Bernstein<double, 3>& depth, double low, double high)
{
    const bool falling = depth(low) > 0;
    const Bernstein<double, 2> slope = derivative(depth);
    double tau = 0.5 * (low + high);
    for (int round = 0; round < 80; ++round) {
        const double value = depth(tau);
        ((value > 0) == falling ? low : high) = tau;
        double next = tau - value / slope(tau);
        if (!(next >= low && next <= high))
            next = 0.5 * (low + high);
        const double moved = std::abs(next - tau);
        tau = next;
        if (moved <= 4e-16)
            break;
    }
    return tau;
}

}  // namespace

//! [intervals_between_roots]
// Cut at its extrema, the cubic is monotone: a piece whose ends differ in sign holds exactly one root. A
// double root that rounding hides costs nothing, for there the depth is within rounding of zero.
PenetrationIntervals intervals_between_roots(const Bernstein<double, 3>& depth, double start)
{
    const InnerRoots cuts = extrema(derivative(depth));
    PenetrationIntervals result;
    double left = start, left_depth = depth(start), entered = start;
    bool inside = left_depth < 0;
    for (int piece = 0; piece <= cuts.count; ++piece) {
        const double right = piece < cuts.count ? std::max(start, cuts.at[piece]) : 1;
        const double right_depth = depth(right);
        if (!inside && right_depth < 0)
            entered = left_depth > 0 ? root_between(depth, left, right) : left;
        if (inside && right_depth >= 0)
            result.add({entered, right_depth > 0 ? root_between(depth, left, right) : right});
        inside = right_depth < 0;
        left = right;
        left_depth = right_depth;
    }
    if (inside)
        result.add({entered, 1});
    return result;
}
//! [intervals_between_roots]

}  // namespace enduring
