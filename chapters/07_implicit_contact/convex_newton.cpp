#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "chapters/07_implicit_contact/dual_friction.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

using Eigen::VectorXd;

namespace {

//! [line_search]
/// How far to go along a direction: to where the slope of the objective,
/// which only rises, has nearly reached zero.
/// @param velocities, rates  of the pairs after the change and along the direction: they do not bend along
///     the way
/// @param impulses           that the pairs answer to the change
double step_length(const ContactProblem& problem, const VectorXd& change, const VectorXd& direction,
                   const std::vector<Vec3>& velocities, const std::vector<Vec3>& rates,
                   const VectorXd& impulses)
{
    const VectorXd mass_direction = times_mass(problem, direction);
    const double slope_t0 = mass_direction.dot(change), curvature = mass_direction.dot(direction);
    const auto slope_with = [&](double t, const auto& impulse_of) {
        double slope = slope_t0 + t * curvature;
        for (std::size_t i = 0; i < problem.rows.size(); ++i)
            slope -= rates[i].dot(impulse_of(i) - problem.rows[i].acting);
        return slope;
    };
    const auto slope_at = [&](double t) {
        return slope_with(t, [&](std::size_t i) {
            return problem.pushed_by(problem.rows[i], velocities[i] + t * rates[i]).total();
        });
    };
    double low = 0, high = 1;
    double slope_low = slope_with(
        low, [&](std::size_t i) { return impulses.segment<3>(static_cast<Eigen::Index>(3 * i)); });
    double slope_high = slope_at(high);
    const double enough = 0.1 * std::abs(slope_low);
    while (slope_high < -enough && high < 64) {
        low = high;
        slope_low = slope_high;
        high *= 2;
        slope_high = slope_at(high);
    }
    if (std::abs(slope_high) <= enough)
        return high;
    for (int i = 0; i < 60; ++i) {
        // The secant's place, kept off the ends, where the slope bends sharply.
        const double secant = low - slope_low * (high - low) / (slope_high - slope_low),
                     margin = 0.1 * (high - low);
        const double middle = std::clamp(secant, low + margin, high - margin), slope = slope_at(middle);
        if (std::abs(slope) <= enough)
            return middle;
        (slope < 0 ? low : high) = middle;
        (slope < 0 ? slope_low : slope_high) = slope;
    }
    return low;
}
//! [line_search]

}  // namespace

//! [solve_convex]
ProblemSolution solve_convex(const ContactProblem& problem, NewtonMatrix& matrix,
                             const ProblemSolution& begin, double tolerance, double least_speed,
                             int max_steps)
{
    ProblemSolution solution{begin.change, begin.impulses};
    DualFriction friction(problem);
    for (;; ++solution.newton_steps) {
        const std::vector<Vec3> velocities = velocities_after(problem, solution.change);
        const Answers answers = answers_at(problem, velocities);
        const VectorXd gradient = times_mass(problem, solution.change) - answers.unbalanced;
        solution.residual = residual_from(problem, gradient, answers.total, least_speed);
        solution.converged = solution.residual <= tolerance;
        if (solution.converged || solution.newton_steps == max_steps)
            return solution;
        const VectorXd direction = matrix.solve(problem, friction.hessians(answers.pushes, velocities),
                                                -gradient);
        const std::vector<Vec3> rates = rates_of(problem, direction);
        friction.follow(velocities, rates);
        const double part = step_length(problem, solution.change, direction, velocities, rates,
                                        answers.impulses);
        solution.change += part * direction;
        solution.impulses += part * (matrix.tangent(answers.impulses, rates) - solution.impulses);
    }
}
//! [solve_convex]

}  // namespace enduring
