#include "chapters/07_implicit_contact/contact_problem.hpp"

#include "chapters/07_implicit_contact/limit_search.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

using Eigen::VectorXd;

VectorXd times_mass(const ContactProblem& problem, const VectorXd& x)
{
    VectorXd product(x.size());
    for (const BodyBlock& block : problem.blocks)
        product.segment(block.first, block.mass.rows()).noalias() = block.mass *
                                                                    x.segment(block.first, block.mass.rows());
    return product;
}

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

namespace {

/// Its length in the norm of A^-1.
double speed_of(const ContactProblem& problem, const VectorXd& momentum)
{
    double squared = 0;
    for (const BodyBlock& block : problem.blocks)
        squared +=
            block.factor.matrixL().solve(momentum.segment(block.first, block.mass.rows())).squaredNorm();
    return std::sqrt(squared);
}

}  // namespace

double residual_from(const ContactProblem& problem, const VectorXd& gradient, const VectorXd& total,
                     double least_speed)
{
    return speed_of(problem, gradient) / std::max(least_speed, speed_of(problem, total));
}

Vec3 PairRow::rate_of(const VectorXd& change) const
{
    Vec3 rate = Vec3::Zero();
    for (const VertexMotion& part : moving())
        with_fixed_size(part, [&]<class Motion>(int first, const Motion& motion) {
            rate.noalias() += motion * change.segment<Motion::ColsAtCompileTime>(first);
        });
    return rate;
}

Vec3 PairRow::velocity_after(const VectorXd& change) const { return velocity + rate_of(change); }

void PairRow::add_impulse(const Vec3& impulse, VectorXd& sum) const
{
    for (const VertexMotion& part : moving())
        with_fixed_size(part, [&]<class Motion>(int first, const Motion& motion) {
            sum.segment<Motion::ColsAtCompileTime>(first).noalias() += motion.transpose() * impulse;
        });
}

namespace {

/// The block that a coordinate belongs to; null if none of these.
const BodyBlock* block_of(const std::vector<BodyBlock>& blocks, int coordinate)
{
    const auto next = std::upper_bound(
        blocks.begin(), blocks.end(), coordinate,
        [](int wanted, const BodyBlock& block) { return wanted < block.first; });
    if (next == blocks.begin() || coordinate >= (next - 1)->first + (next - 1)->mass.rows())
        return nullptr;
    return &*(next - 1);
}

}  // namespace

Mat3 PairRow::response(const std::vector<BodyBlock>& blocks) const
{
    Mat3 sum = Mat3::Zero();
    for (int i = 0; i < part_count;) {
        const BodyBlock* block = block_of(blocks, parts[static_cast<std::size_t>(i)].first);
        if (!block) {
            ++i;
            continue;
        }
        Eigen::MatrixXd impulses = Eigen::MatrixXd::Zero(block->mass.rows(), 3);
        // the parts of one body stand together
        for (; i < part_count && block_of(blocks, parts[static_cast<std::size_t>(i)].first) == block; ++i) {
            const VertexMotion& part = parts[static_cast<std::size_t>(i)];
            impulses.middleRows(part.first - block->first, part.rate.cols()) += part.rate.transpose();
        }
        sum += impulses.transpose() * block->factor.solve(impulses);
    }
    return sum;
}

double residual_of(const ContactProblem& problem, const VectorXd& change, double least_speed)
{
    const Answers answers = answers_to(problem, change);
    return residual_from(problem, times_mass(problem, change) - answers.missing, answers.total, least_speed);
}

namespace {

/// Residual below which Newton's method on the real equation needs nobody to lead it.
constexpr double near_the_answer = 0.01;

std::vector<Mat3> stiffenings_at(const ContactProblem& problem, const VectorXd& change)
{
    std::vector<Mat3> stiffenings;
    for (const PairRow& row : problem.rows)
        stiffenings.push_back(answer(row.law, row.velocity_after(change), problem.step).stiffening);
    return stiffenings;
}

/// One step on the real equation, or a part of it; false where the residual falls by less than a fifth: a
/// crawl would only lead away from where the convex problems go.
bool newton_step(const ContactProblem& problem, NewtonMatrix& matrix, double least_speed,
                 ProblemSolution& solution)
{
    const Answers answers = answers_to(problem, solution.change);
    const VectorXd direction = matrix.solve(problem, stiffenings_at(problem, solution.change),
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
    LimitSearch limits;
    while (solution.residual > tolerance && solution.newton_steps < most_steps) {
        ProblemSolution tried = solution;
        while (tried.residual > tolerance && newton_step(problem, matrix, least_speed, tried)) {}
        solution.newton_steps = tried.newton_steps;
        if (tried.residual <= tolerance) {
            solution = tried;
        } else {
            // What Newton's method has tried is no answer to any limits: the search goes on from its own.
            limits.advance(problem, solution.change);
            lead_on();
        }
    }
    solution.converged = solution.residual <= tolerance;
    return solution;
}
//! [solve]

}  // namespace enduring
