#include "chapters/07_implicit_contact/implicit_contact.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enduring {

double least_speed(const World& world, const Island& island, double dt)
{
    double mass = 0, largest = 0;
    for (const int place : island.bodies) {
        const Body& body = *world.bodies[static_cast<std::size_t>(place)];
        mass += body.mass();
        largest = std::max(largest, body.size());
    }
    return std::sqrt(mass) * std::max(scale_parts.least_answer * largest / dt, world.gravity.norm() * dt);
}

namespace {

/// Of a pair's vertices at the start of the step [m].
double largest_coordinate(const World& world, const Contact& contact)
{
    double largest = 0;
    for (int i = 0; i < contact.vertex_count(); ++i)
        largest = std::max(largest, contact_vertex(world, contact, i, 0).cwiseAbs().maxCoeff());
    return largest;
}

}  // namespace

//! [rounding_residual]
double rounding_speed(const World& world, const StepProblem& step)
{
    constexpr double digits = 4, epsilon = std::numeric_limits<double>::epsilon();
    const double dt = step.problem.step.dt;
    double sum = 0;  // of squares, for no pair's rounding depends on another one's
    for (const ElementLaw& law : step.problem.elements)
        sum += law.rounding * law.rounding;
    for (std::size_t i = 0; i < step.of_row.size(); ++i) {
        const PairRow& row = step.problem.rows[i];
        if (row.acting.isZero(0))
            continue;
        const double mass = mass_along(row.law.normal, step.responses[i]);
        // of a coordinate, and of an impulse, which moves its bodies
        const double moved = epsilon * (largest_coordinate(world, *step.of_row[i]) +
                                        (mass > 0 ? dt * row.acting.norm() / mass : 0)),
                     impulse = digits * row.law.stiffness * dt * moved;
        sum += impulse * impulse / mass;
    }
    return std::sqrt(sum);
}

double rounding_residual(const World& world, const StepProblem& step, double least_speed)
{
    Eigen::VectorXd total = Eigen::VectorXd::Zero(step.problem.size);
    for (const PairRow& row : step.problem.rows)
        row.add_impulse(row.acting, total);
    const double rounding = rounding_speed(world, step),
                 acting = std::max(least_speed, speed_of(step.problem, total));
    constexpr double small = 1e-2;  // with such a residual, what acts is as large as what pairs answer
    if (rounding <= small * acting)
        return rounding / acting;
    // where nothing acts yet, the answer is no rounding
    const Answers answers = answers_to(step.problem, Eigen::VectorXd::Zero(step.problem.size));
    return rounding / std::max(acting, speed_of(step.problem, answers.total));
}
//! [rounding_residual]

}  // namespace enduring
