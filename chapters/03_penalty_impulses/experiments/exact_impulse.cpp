#include "chapters/03_penalty_impulses/experiments/exact_impulse.hpp"

#include "chapters/03_penalty_impulses/penetration.hpp"

#include <boost/math/quadrature/gauss.hpp>

namespace enduring {
namespace {

/// depth n, both with the unit normal of that time.
Vec3 penetration_vector(const Bernstein<Vec3, 2>& normal, const Bernstein<double, 3>& depth, double tau)
{
    const Vec3 n = normal(tau);
    return depth(tau) / n.squaredNorm() * n;
}

}  // namespace

Vec3 exact_impulse(const PairStep& step, double start, double k, double dt, int pieces)
{
    const Bernstein<Vec3, 2> normal = contact_normal(step);
    const Bernstein<double, 3> depth = penetration_depth(normal, step);
    Vec3 integral = Vec3::Zero();
    for (const Interval& inside : penetration_intervals(depth, start))
        for (int piece = 0; piece < pieces; ++piece)
            for (int axis = 0; axis < 3; ++axis)
                integral[axis] += boost::math::quadrature::gauss<double, 15>::integrate(
                    [&](double tau) { return penetration_vector(normal, depth, tau)[axis]; },
                    inside.from + inside.length() * piece / pieces,
                    inside.from + inside.length() * (piece + 1) / pieces);
    return -k * dt * integral;
}

}  // namespace enduring
