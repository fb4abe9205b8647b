#include "chapters/07_implicit_contact/contact_problem.hpp"

#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

using Eigen::VectorXd;

VectorXd times_mass(const ContactProblem& problem, const VectorXd& x)
{
    VectorXd product(x.size());
    for (const BodyBlock& block : problem.blocks)
        product.segment(block.first, block.mass.rows()).noalias() = block.mass *
                                                                    x.segment(block.first, block.mass.rows());
    return product;
}

/// Its length in the norm of A^-1.
double speed_of(const ContactProblem& problem, const VectorXd& momentum)
{
    double squared = 0;
    for (const BodyBlock& block : problem.blocks)
        squared +=
            block.factor.matrixL().solve(momentum.segment(block.first, block.mass.rows())).squaredNorm();
    return std::sqrt(squared);
}

/// What the pairs answer to a change, all impulses as momentum of the coordinates.
struct Answers {
    VectorXd total, missing;  ///< all; without what acts already
};

Answers answers_to(const ContactProblem& problem, const VectorXd& change)
{
    Answers answers{VectorXd::Zero(problem.size), VectorXd::Zero(problem.size)};
    for (const PairRow& row : problem.rows) {
        const PairAnswer made = answer(row.law, row.velocity_after(change), problem.step);
        const Vec3 impulse = made.normal_impulse + made.friction;
        row.add_impulse(impulse, answers.total);
        row.add_impulse(impulse - row.acting, answers.missing);
    }
    return answers;
}

double residual_from(const ContactProblem& problem, const VectorXd& gradient, const VectorXd& total,
                     double least_speed)
{
    return speed_of(problem, gradient) / std::max(least_speed, speed_of(problem, total));
}

//! [line_search]
/// How far to go along a direction: to where the slope of the objective,
/// which only rises, has nearly reached zero.
double step_length(const ContactProblem& problem, const VectorXd& change, const VectorXd& direction)
{
    const VectorXd mass_direction = times_mass(problem, direction);
    const auto slope_at = [&](double t) {
        double slope = mass_direction.dot(change + t * direction);
        for (const PairRow& row : problem.rows) {
            const PairAnswer made = answer(row.law, row.velocity_after(change + t * direction), problem.step);
            slope -= row.rate_of(direction).dot(made.normal_impulse + made.friction - row.acting);
        }
        return slope;
    };
    const double enough = 0.1 * std::abs(slope_at(0));
    double low = 0, high = 1, slope_high = slope_at(high);
    while (slope_high < -enough && high < 64) {
        low = high;
        high *= 2;
        slope_high = slope_at(high);
    }
    if (std::abs(slope_high) <= enough)
        return high;
    double slope_low = slope_at(low);
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

Vec3 PairRow::rate_of(const VectorXd& change) const
{
    Vec3 rate = Vec3::Zero();
    for (int i = 0; i < part_count; ++i) {
        const VertexMotion& part = parts[static_cast<std::size_t>(i)];
        rate.noalias() += part.rate * change.segment(part.first, part.rate.cols());
    }
    return rate;
}

Vec3 PairRow::velocity_after(const VectorXd& change) const { return velocity + rate_of(change); }

void PairRow::add_impulse(const Vec3& impulse, VectorXd& sum) const
{
    for (int i = 0; i < part_count; ++i) {
        const VertexMotion& part = parts[static_cast<std::size_t>(i)];
        sum.segment(part.first, part.rate.cols()).noalias() += part.rate.transpose() * impulse;
    }
}

Mat3 PairRow::response(const std::vector<BodyBlock>& blocks) const
{
    Mat3 sum = Mat3::Zero();
    for (const BodyBlock& block : blocks) {
        Eigen::MatrixXd impulses = Eigen::MatrixXd::Zero(block.mass.rows(), 3);
        const auto belongs = [&](const VertexMotion& part) {
            return part.first >= block.first && part.first < block.first + block.mass.rows();
        };
        bool any = false;
        for (int i = 0; i < part_count; ++i)
            if (const VertexMotion& part = parts[static_cast<std::size_t>(i)]; belongs(part)) {
                impulses.middleRows(part.first - block.first, part.rate.cols()) += part.rate.transpose();
                any = true;
            }
        if (any)
            sum += impulses.transpose() * block.factor.solve(impulses);
    }
    return sum;
}

double residual_of(const ContactProblem& problem, const VectorXd& change, double least_speed)
{
    const Answers answers = answers_to(problem, change);
    return residual_from(problem, times_mass(problem, change) - answers.missing, answers.total, least_speed);
}

//! [solve_convex]
ProblemSolution solve_convex(const ContactProblem& problem, NewtonMatrix& matrix, const VectorXd& change,
                             double tolerance, double least_speed, int most_steps)
{
    ProblemSolution solution{change};
    for (;; ++solution.newton_steps) {
        const Answers answers = answers_to(problem, solution.change);
        const VectorXd gradient = times_mass(problem, solution.change) - answers.missing;
        solution.residual = residual_from(problem, gradient, answers.total, least_speed);
        solution.converged = solution.residual <= tolerance;
        if (solution.converged || solution.newton_steps == most_steps)
            return solution;
        const VectorXd direction = matrix.solve(problem, solution.change, -gradient);
        solution.change += step_length(problem, solution.change, direction) * direction;
    }
}
//! [solve_convex]

namespace {

/// Residual below which Newton's method on the real equation needs nobody to lead it.
constexpr double near_the_answer = 0.01;

/// Limits of friction as the present answer has them.
void take_limits(ContactProblem& problem, const VectorXd& change)
{
    for (PairRow& row : problem.rows)
        row.law.pressing = answer(row.law, row.velocity_after(change), problem.step).normal_impulse.norm();
}

/// One step on the real equation, or a part of it; false where the residual falls by less than a fifth: a
/// crawl would only lead away from where the convex problems go.
bool newton_step(const ContactProblem& problem, NewtonMatrix& matrix, double least_speed,
                 ProblemSolution& solution)
{
    const Answers answers = answers_to(problem, solution.change);
    const VectorXd direction = matrix.solve(problem, solution.change,
                                            answers.missing - times_mass(problem, solution.change));
    ++solution.newton_steps;
    for (double part = 1; part >= 0.25; part /= 2) {
        const VectorXd change = solution.change + part * direction;
        const double residual = residual_of(problem, change, least_speed);
        if (residual > 0.8 * solution.residual)
            continue;
        solution.change = change;
        solution.residual = residual;
        return true;
    }
    return false;
}

}  // namespace

//! [solve]
ProblemSolution solve(ContactProblem problem, NewtonMatrix& matrix, double tolerance, double least_speed,
                      int most_steps)
{
    ProblemSolution solution{VectorXd::Zero(problem.size)};
    const auto see_residual = [&] {
        problem.step.limit = FrictionLimit::coupled;
        solution.residual = residual_of(problem, solution.change, least_speed);
    };
    const auto lead_on = [&] {
        problem.step.limit = FrictionLimit::lagged;
        const ProblemSolution led = solve_convex(problem, matrix, solution.change,
                                                 std::max(tolerance, 0.01 * solution.residual), least_speed);
        solution.change = led.change;
        solution.newton_steps += led.newton_steps;
        see_residual();
    };
    see_residual();
    if (solution.residual > near_the_answer)
        lead_on();
    while (solution.residual > tolerance && solution.newton_steps < most_steps)
        if (!newton_step(problem, matrix, least_speed, solution)) {
            take_limits(problem, solution.change);
            lead_on();
        }
    solution.converged = solution.residual <= tolerance;
    return solution;
}
//! [solve]

}  // namespace enduring
