#include "exercises/03_penalty_impulses/2_length_of_the_normal.hpp"

#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "chapters/03_penalty_impulses/penetration.hpp"

#include <array>
#include <cmath>

namespace enduring {

/// A point of Gauss on [0, 1]: three of them integrate polynomials of degree 5 exactly.
struct GaussPoint {
    double place, weight;
};
const std::array<GaussPoint, 3> gauss_points{
    {{0.5 - std::sqrt(0.15), 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + std::sqrt(0.15), 5.0 / 18}}};

Vec3 impulse_by_length_of_visit(const PairStep& step, double start, double k, double dt)
{
    const Bernstein<Vec3, 2> normal = contact_normal(step);
    const Bernstein<double, 3> depth = penetration_depth(normal, step);
    Vec3 sum = Vec3::Zero();
    for (const Interval& inside : penetration_intervals(depth, start)) {
        const Bernstein<Vec3, 2> normal_inside = restricted(normal, inside);
        const Vec3 integral = integral_of_product(restricted(depth, inside), normal_inside);
        sum += inside.length() / mean_squared_length(normal_inside) * integral;
    }
    return -k * dt * sum;
}

Vec3 impulse_by_unit_normals(const PairStep& step, double start, double k, double dt, int pieces)
{
    const Bernstein<Vec3, 2> normal = contact_normal(step);
    const Bernstein<double, 3> depth = penetration_depth(normal, step);
    Vec3 sum = Vec3::Zero();
    for (const Interval& inside : penetration_intervals(depth, start)) {
        const double width = inside.length() / pieces;
        for (int piece = 0; piece < pieces; ++piece)
            for (const auto& [place, weight] : gauss_points) {
                const double tau = inside.from + (piece + place) * width;
                const Vec3 n = normal(tau);
                sum += weight * width * depth(tau) / n.squaredNorm() * n;
            }
    }
    return -k * dt * sum;
}

int pieces_for(const PairStep& step, double tolerance)
{
    Vec3 coarse = impulse_by_unit_normals(step, 0, 1, 1, 1);
    for (int pieces = 1; pieces < 64; pieces *= 2) {
        const Vec3 fine = impulse_by_unit_normals(step, 0, 1, 1, 2 * pieces);
        if ((fine - coarse).norm() <= tolerance * fine.norm())
            return pieces;
        coarse = fine;
    }
    return 64;
}

}  // namespace enduring
