// By quadrature: three points of Gauss are exact for degree 5, and need
// neither the twelve numbers nor `restricted`.
#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "chapters/03_penalty_impulses/penetration.hpp"

#include <cmath>
#include <utility>

namespace enduring {
namespace {

/// Integral of depth(tau) normal(tau) over a part of the step.
Vec3 by_gauss(const Bernstein<double, 3>& depth, const Bernstein<Vec3, 2>& normal, const Interval& part)
{
    const double middle = 0.5 * (part.from + part.to), half = 0.5 * part.length();
    Vec3 sum = Vec3::Zero();
    for (const auto& [place, weight] :
         {std::pair(-std::sqrt(0.6), 5.0 / 9), std::pair(0.0, 8.0 / 9), std::pair(std::sqrt(0.6), 5.0 / 9)}) {
        const double tau = middle + half * place;
        sum += weight * half * depth(tau) * normal(tau);
    }
    return sum;
}

}  // namespace

Vec3 discrete_impulse(const PairInstant& end, double k, double dt)
{
    const Vec3 normal = end.side_1.cross(end.side_2);
    if (normal.norm() == 0)
        return Vec3::Zero();
    const Vec3 unit = normal / normal.norm();
    return -k * dt * std::fmin(unit.dot(end.offset), 0) * unit;
}

Vec3 integral_of_product(const Bernstein<double, 3>& depth, const Bernstein<Vec3, 2>& normal)
{
    return by_gauss(depth, normal, {0, 1});
}

Vec3 continuous_impulse(const PairStep& step, double start, double k, double dt)
{
    const Bernstein<Vec3, 2> normal = contact_normal(step);
    const double squared_length = mean_squared_length(normal);
    Vec3 integral = Vec3::Zero();
    if (squared_length == 0)
        return integral;
    const Bernstein<double, 3> depth = penetration_depth(normal, step);
    for (const Interval& inside : penetration_intervals(depth, start))
        integral += by_gauss(depth, normal, inside);
    return -k * dt / squared_length * integral;
}

}  // namespace enduring
