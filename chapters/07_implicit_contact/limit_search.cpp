#include "chapters/07_implicit_contact/limit_search.hpp"

#include <algorithm>

namespace enduring {
namespace {

constexpr double largest_part = 64;

/// Of each pair, how far the normal impulse is above what its limit was taken from [N s].
Eigen::VectorXd errors_of(const ContactProblem& problem, const Eigen::VectorXd& change)
{
    Eigen::VectorXd errors(static_cast<Eigen::Index>(problem.rows.size()));
    for (Eigen::Index i = 0; i < errors.size(); ++i) {
        const PairRow& row = problem.rows[static_cast<std::size_t>(i)];
        errors[i] = normal_impulse(row.law, row.velocity_after(change), problem.step) -
                    row.law.lagged_normal_impulse;
    }
    return errors;
}

}  // namespace

//! [advance]
void LimitSearch::advance(ContactProblem& problem, const Eigen::VectorXd& change)
{
    const Eigen::VectorXd error = errors_of(problem, change);
    if (last_error_.size() > 0 && !last_error_.isZero(0)) {
        // A round that took this part has left so much of the error; it should have left nothing.
        const double left = error.dot(last_error_) / last_error_.squaredNorm();
        part_ = std::min(largest_part, part_ * (left < 0.5 ? 1 / (1 - left) : 2));
    }
    last_error_ = error;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        double& limit = problem.rows[i].law.lagged_normal_impulse;
        limit = std::max(0.0, limit + part_ * error[static_cast<Eigen::Index>(i)]);
    }
}
//! [advance]

//! [search]
ProblemSolution solve_with_limit_search(ContactProblem problem, NewtonMatrix& matrix,
                                        const ProblemSolution& begin, double tolerance, double least_speed,
                                        int max_steps)
{
    ProblemSolution solution = begin;
    LimitSearch limits;
    for (int steps = 0; steps < max_steps; ++steps) {
        const double left = true_residual(problem, solution.change, least_speed);
        if (left <= tolerance)
            break;
        if (steps > 0)
            limits.advance(problem, solution.change);
        const int before = solution.newton_steps;
        solution = solve_convex(problem, matrix, solution, std::max(tolerance, 0.1 * left), least_speed,
                                std::min(max_convex_steps, max_steps - steps));
        steps += solution.newton_steps;
        solution.newton_steps += before;
    }
    return solution;
}
//! [search]

}  // namespace enduring
