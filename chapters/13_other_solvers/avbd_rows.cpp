#include "chapters/13_other_solvers/avbd_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enduring {

//! [dual]
AugmentedConstraint dual_update(const AugmentedConstraint& constraint, double error, double least,
                                double most, const AvbdSettings& settings)
{
    const double force = std::clamp(constraint.multiplier + constraint.stiffness * error, least,
                                    most);  // (11)
    const bool at_bound = force <= least || force >= most;
    const double grown = constraint.stiffness + (at_bound ? 0 : settings.beta * std::abs(error));  // (16)
    return {force, std::min(settings.most_stiffness, grown)};
}
//! [dual]

Vector6 way_between(const Pose& from, const Pose& to)
{
    return (Vector6() << to.position - from.position,
            rotation_vector(to.orientation * from.orientation.conjugate()))
        .finished();
}

namespace {

Vector6 jacobian(const Vec3& direction, const Vec3& r)
{
    return (Vector6() << direction, r.cross(direction)).finished();
}

}  // namespace

AvbdRow::AvbdRow(const MethodStep& step, const ContactPoint& of)
    : point(&of), directions{of.normal, of.tangent_1, of.tangent_2}
{
    for (std::size_t i = 0; i < 3; ++i) {
        j_a[i] = jacobian(directions[i], step.lever_a(of));
        j_b[i] = -jacobian(directions[i], step.lever_b(of));
    }
}

double AvbdRow::error(const MethodStep& step, int i) const
{
    const auto n = static_cast<std::size_t>(i);
    double error = start[i];
    for (const auto& [index, j] : {std::pair(point->a, &j_a[n]), std::pair(point->b, &j_b[n])}) {
        const MovingBody& body = step.bodies[static_cast<std::size_t>(index)];
        if (body.moves)
            error -= j->dot(way_between(body.start, body.pose));
    }
    step.each_node(*point, [&](const SoftNode& node, double weight) {
        error -= weight * directions[n].dot(node.place - node.start);
    });
    return error;
}

AvbdRow::Push AvbdRow::push(const MethodStep& step) const
{
    Vec3 force;
    for (int i = 0; i < 3; ++i) {
        const AugmentedConstraint& row = constraints[static_cast<std::size_t>(i)];
        force[i] = row.multiplier + row.stiffness * error(step, i);
    }
    force.x() = std::max(0.0, force.x());
    const double length = force.tail<2>().norm(), bound = point->mu_s * force.x();
    const bool is_full = length >= bound;
    if (is_full && length > 0)
        force.tail<2>() *= bound / length;
    return {force, is_full};
}

void AvbdRow::update(const MethodStep& step, const AvbdSettings& settings)
{
    constexpr double no_bound = std::numeric_limits<double>::max();
    const auto [force, is_full] = push(step);
    slips = is_full;
    constraints[0] = dual_update(constraints[0], error(step, 0), 0, no_bound, settings);
    for (std::size_t k = 1; k < 3; ++k) {
        const double now = force[static_cast<int>(k)];
        constraints[k] = !is_full ? dual_update(constraints[k], error(step, static_cast<int>(k)), -no_bound,
                                                no_bound, settings)
                                  : AugmentedConstraint{now, constraints[k].stiffness};
    }
}

}  // namespace enduring
