#include "chapters/11_exact_contact/force_memory.hpp"

#include "chapters/07_implicit_contact/limit_search.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/springs_of_problem.hpp"

#include <algorithm>
#include <limits>

namespace enduring {
namespace {

using Eigen::VectorXd;

/// The momentum that impulses of all pairs give to the coordinates.
VectorXd momentum_of(const ContactProblem& springs, const VectorXd& impulses)
{
    VectorXd momentum = VectorXd::Zero(springs.size);
    for (std::size_t i = 0; i < springs.rows.size(); ++i)
        springs.rows[i].add_impulse(impulses.segment<3>(static_cast<Eigen::Index>(3 * i)), momentum);
    return momentum;
}

/// As the problem has them: two or three numbers of each contact.
VectorXd in_dimension(const FrictionProblem& problem, const VectorXd& impulses)
{
    VectorXd numbers(problem.dimension * problem.contacts());
    for (int i = 0; i < problem.contacts(); ++i)
        numbers.segment(problem.dimension * i, problem.dimension) = impulses.segment(3 * i,
                                                                                     problem.dimension);
    return numbers;
}

//! [begin]
/// The change that these impulses make. Velocities are set so that with it each contact has W r + q exactly: what the springs'
/// A has wrong, by its shift or where W is not symmetric, then changes an impulse only by what a pass changes.
ProblemSolution begin_at(const FrictionProblem& problem, ContactProblem& springs, const VectorXd& impulses)
{
    const VectorXd change = times_response(springs, momentum_of(springs, impulses));
    const VectorXd velocities = contact_velocities(problem, in_dimension(problem, impulses));
    for (int i = 0; i < problem.contacts(); ++i) {
        PairRow& row = springs.rows[static_cast<std::size_t>(i)];
        row.velocity = numbers_of(problem, velocities, i) - row.rate_of(change);
    }
    return {change, impulses};
}
//! [begin]

/// What the springs push at a change, with the limits of friction that the same change makes.
VectorXd impulses_at(ContactProblem& springs, const VectorXd& change)
{
    for (PairRow& row : springs.rows)
        row.law.lagged_normal_impulse = normal_impulse(row.law, row.velocity_after(change), springs.step);
    return answers_to(springs, change).impulses;
}

}  // namespace

//! [remember]
void remember_impulses(ContactProblem& springs, const VectorXd& impulses)
{
    for (std::size_t i = 0; i < springs.rows.size(); ++i) {
        PairLaw& law = springs.rows[i].law;
        const Vec3 impulse = impulses.segment<3>(static_cast<Eigen::Index>(3 * i));
        const Vec3 pressed = -impulse / (law.stiffness * springs.step.dt);
        law.depth_t0 = law.normal.dot(pressed);
        law.stretch = pressed - law.depth_t0 * law.normal;
        law.lagged_normal_impulse = std::max(0.0, law.normal.dot(impulse));
    }
}
//! [remember]

/// of a pass' solve: from here on it is sharp, and its springs are what is left of the error
constexpr double sharp_residual = 1e-5;

//! [stiffer_by]
/// After a pass that did not take 70 % of the error: by how much stiffer the springs of the next one are.
double stiffer_by(bool reached, double residual)
{
    if (!reached)
        return 0.1;
    return residual < sharp_residual ? 10 : 1;
}
//! [stiffer_by]

//! [solve_exactly]
ExactSolution solve_exactly(const FrictionProblem& problem, const ExactSettings& settings)
{
    ContactProblem springs = springs_of(problem,
                                        settings.keeps_h ? settings.h : std::min(settings.h, stiffest_h));
    NewtonMatrix matrix;
    const double least_speed = 1e-14 * problem.free_velocity.norm();
    VectorXd impulses = VectorXd::Zero(3 * problem.contacts());
    ExactSolution best{in_dimension(problem, impulses), std::numeric_limits<double>::infinity(), {}, {}};
    double residual = settings.first_residual;
    for (int idle = 0; idle < settings.max_idle_passes;) {
        const int left = settings.max_newton_steps - best.newton_steps;
        if (best.error <= settings.tolerance || left <= 0 ||
            static_cast<int>(best.errors.size()) == settings.max_passes)
            break;
        const ProblemSolution begin = begin_at(problem, springs, impulses);
        remember_impulses(springs, impulses);
        const ProblemSolution found = solve_with_limit_search(springs, matrix, begin, residual, least_speed,
                                                              std::min(left, settings.max_steps_of_pass));
        impulses = impulses_at(springs, found.change);
        const double error = natural_map_error(problem, in_dimension(problem, impulses));
        if (!best.errors.empty() && error > 0.3 * best.errors.back()) {
            const bool reached = true_residual(springs, found.change, least_speed) <= residual;
            if (!settings.keeps_h)
                for (PairRow& row : springs.rows)
                    row.law.stiffness *= stiffer_by(reached, residual);
            if (reached || settings.keeps_h)
                residual = std::max(1e-13, 0.1 * residual);
        }
        idle = error < 0.5 * best.error ? 0 : idle + 1;
        best.errors.push_back(error);
        best.steps.push_back(found.newton_steps);
        best.newton_steps += found.newton_steps;
        if (error < best.error) {
            best.error = error;
            best.impulses = in_dimension(problem, impulses);
        }
    }
    return best;
}
//! [solve_exactly]

}  // namespace enduring
