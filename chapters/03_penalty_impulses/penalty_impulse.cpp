#include "chapters/03_penalty_impulses/penalty_impulse.hpp"

#include "chapters/03_penalty_impulses/penetration.hpp"

namespace enduring {

//! [discrete_impulse]
Vec3 discrete_impulse(const PairInstant& end, double k, double dt)
{
    const Vec3 normal = end.side_1.cross(end.side_2);
    const double depth = normal.dot(end.offset), squared_length = normal.squaredNorm();
    if (depth >= 0 || squared_length == 0)
        return Vec3::Zero();
    return (-k * dt * depth / squared_length) * normal;
}
//! [discrete_impulse]

//! [integral_of_product]
Vec3 integral_of_product(const Bernstein<double, 3>& depth, const Bernstein<Vec3, 2>& normal)
{
    const auto& [d0, d1, d2, d3] = depth.coefficients;
    const auto& [n0, n1, n2] = normal.coefficients;
    // clang-format off
    return ((10 * d0 + 6 * d1 + 3 * d2 + d3) * n0
            + (4 * d0 + 6 * d1 + 6 * d2 + 4 * d3) * n1
            + (d0 + 3 * d1 + 6 * d2 + 10 * d3) * n2) / 60;
    // clang-format on
}
//! [integral_of_product]

//! [continuous_impulse]
Vec3 continuous_impulse(const PairStep& step, double start, double k, double dt)
{
    const Bernstein<Vec3, 2> normal = contact_normal(step);
    const Bernstein<double, 3> depth = penetration_depth(normal, step);

    Vec3 integral = Vec3::Zero();
    for (const Interval& inside : penetration_intervals(depth, start))
        integral += inside.length() *
                    integral_of_product(restricted(depth, inside), restricted(normal, inside));

    // Depth and direction still carry the normal's length, each once: divide by L_k twice.
    const double squared_length = mean_squared_length(normal);
    return squared_length > 0 ? Vec3(-k * dt / squared_length * integral) : Vec3::Zero();
}
//! [continuous_impulse]

}  // namespace enduring
