#include "exercises/03_penalty_impulses/2_length_of_the_normal.hpp"

#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "chapters/03_penalty_impulses/penetration.hpp"
#include "exercises/not_implemented_yet.hpp"

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
    not_implemented_yet("3.2");
}

Vec3 impulse_by_unit_normals(const PairStep& step, double start, double k, double dt, int pieces)
{
    not_implemented_yet("3.2");
}

int pieces_for(const PairStep& step, double tolerance)
{
    not_implemented_yet("3.2");
}

}  // namespace enduring
