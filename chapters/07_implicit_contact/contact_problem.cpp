#include "chapters/07_implicit_contact/contact_problem.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace enduring {

using Eigen::VectorXd;

namespace {

/// A product of two matrices so small that the compiler unrolls it.
template <class One, class Other>
auto small_product(const One& one, const Other& other)
{
    Eigen::Matrix<double, One::RowsAtCompileTime, Other::ColsAtCompileTime> sum;
    for (int column = 0; column < sum.cols(); ++column) {
        sum.col(column) = other(0, column) * one.col(0);
        for (int i = 1; i < one.cols(); ++i)
            sum.col(column) += other(i, column) * one.col(i);
    }
    return sum;
}

/// The product of all bodies' blocks, of one kind, with a vector.
/// @param of_whole  VectorXd(matrix of a body with all its nodes, its part of x)
template <class OfWhole>
VectorXd times(const ContactProblem& problem, Eigen::MatrixXd BodyBlock::*kind, const VectorXd& x,
               const OfWhole& of_whole)
{
    VectorXd product(x.size());
    for (const BodyBlock& block : problem.blocks)
        if (block.whole)
            product.segment(block.first, block.size()) = of_whole(*block.whole,
                                                                  x.segment(block.first, block.size()));
        else if (block.size() == 6)  // of a rigid body
            product.segment<6>(block.first) = small_product(
                Eigen::Map<const Eigen::Matrix<double, 6, 6>>((block.*kind).data()),
                x.segment<6>(block.first));
        else
            product.segment(block.first, block.size()).noalias() = block.*kind *
                                                                   x.segment(block.first, block.size());
    return product;
}

}  // namespace

VectorXd times_mass(const ContactProblem& problem, const VectorXd& x)
{
    return times(problem, &BodyBlock::mass, x,
                 [](const WholeMatrix& whole, const VectorXd& own) { return whole.times(own); });
}

VectorXd times_response(const ContactProblem& problem, const VectorXd& momentum)
{
    return times(problem, &BodyBlock::response, momentum,
                 [](const WholeMatrix& whole, const VectorXd& own) { return whole.respond(own); });
}

//! [rows]
PairPush ContactProblem::pushed_by(const PairRow& row, const Vec3& row_velocity) const
{
    return row.element < 0 ? pushed(row.law, row_velocity, step)
                           : PairPush{element_of(row).impulse(row_velocity)};
}

Mat3 ContactProblem::hessian_by(const PairRow& row, const PairPush& push, const Vec3& row_velocity) const
{
    return row.element < 0 ? hessian_of(row.law, push, step) : element_of(row).hessian(row_velocity);
}
//! [rows]

namespace {

/// @param push_of  PairPush(row, velocity after the change)
template <class PushOf>
Answers answers_by(const ContactProblem& problem, const std::vector<Vec3>& velocities, const PushOf& push_of)
{
    const auto pairs = static_cast<Eigen::Index>(problem.rows.size());
    Answers answers{{}, VectorXd(3 * pairs), VectorXd::Zero(problem.size), VectorXd::Zero(problem.size)};
    answers.pushes.reserve(velocities.size());
    for (Eigen::Index i = 0; i < pairs; ++i) {
        const PairRow& row = problem.rows[static_cast<std::size_t>(i)];
        const Vec3& velocity = velocities[static_cast<std::size_t>(i)];
        const Vec3 impulse = answers.pushes.emplace_back(push_of(row, velocity)).total();
        answers.impulses.segment<3>(3 * i) = impulse;
        row.add_impulse(impulse, answers.total);
        row.add_impulse(impulse - row.acting, answers.unbalanced);
    }
    return answers;
}

}  // namespace

std::vector<Vec3> rates_of(const ContactProblem& problem, const VectorXd& change)
{
    std::vector<Vec3> rates;
    rates.reserve(problem.rows.size());
    for (const PairRow& row : problem.rows)
        rates.push_back(row.rate_of(change));
    return rates;
}

std::vector<Vec3> velocities_after(const ContactProblem& problem, const VectorXd& change)
{
    std::vector<Vec3> velocities = rates_of(problem, change);
    for (std::size_t i = 0; i < velocities.size(); ++i)
        velocities[i] = problem.rows[i].velocity + velocities[i];
    return velocities;
}

Answers answers_at(const ContactProblem& problem, const std::vector<Vec3>& velocities)
{
    return answers_by(problem, velocities, [&](const PairRow& row, const Vec3& velocity) {
        return problem.pushed_by(row, velocity);
    });
}

Answers answers_to(const ContactProblem& problem, const VectorXd& change)
{
    return answers_at(problem, velocities_after(problem, change));
}

double speed_of(const ContactProblem& problem, const VectorXd& momentum)
{
    const VectorXd change = times(
        problem, &BodyBlock::response, momentum,
        [](const WholeMatrix& whole, const VectorXd& own) { return own.cwiseQuotient(whole.masses); });
    return std::sqrt(std::max(0.0, momentum.dot(change)));
}

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

/// The block that a coordinate belongs to; together they have all.
const BodyBlock& block_of(const std::vector<BodyBlock>& blocks, int coordinate)
{
    return *std::prev(
        std::upper_bound(blocks.begin(), blocks.end(), coordinate,
                         [](int wanted, const BodyBlock& block) { return wanted < block.first; }));
}

}  // namespace

Mat3 PairRow::response(const std::vector<BodyBlock>& blocks) const
{
    Mat3 sum = Mat3::Zero();
    for (const VertexMotion& one : moving()) {
        const BodyBlock& block = block_of(blocks, one.first);
        if (block.whole)
            continue;
        for (const VertexMotion& other : moving())
            if (&block_of(blocks, other.first) == &block)
                with_fixed_size(one, [&]<class One>(int row, const One& rate) {
                    with_fixed_size(other, [&]<class Other>(int column, const Other& other_rate) {
                        const auto own =
                            block.response.block<One::ColsAtCompileTime, Other::ColsAtCompileTime>(
                                row - block.first, column - block.first);
                        sum += small_product(small_product(rate, own), other_rate.transpose());
                    });
                });
    }
    return sum;
}

VectorXd impulses_acting(const ContactProblem& problem)
{
    VectorXd impulses(3 * problem.rows.size());
    for (std::size_t i = 0; i < problem.rows.size(); ++i)
        impulses.segment<3>(static_cast<Eigen::Index>(3 * i)) = problem.rows[i].acting;
    return impulses;
}

ProblemSolution unchanged(const ContactProblem& problem)
{
    return {VectorXd::Zero(problem.size), impulses_acting(problem)};
}

namespace {

double residual_of(const ContactProblem& problem, const VectorXd& change, const Answers& answers,
                   double least_speed)
{
    return residual_from(problem, times_mass(problem, change) - answers.unbalanced, answers.total,
                         least_speed);
}

}  // namespace

double residual_of(const ContactProblem& problem, const VectorXd& change, double least_speed)
{
    return residual_of(problem, change, answers_to(problem, change), least_speed);
}

double true_residual(const ContactProblem& problem, const VectorXd& change, double least_speed)
{
    const auto own_limit = [&](const PairRow& row, const Vec3& velocity) {
        if (row.element >= 0)
            return problem.pushed_by(row, velocity);
        PairLaw law = row.law;
        law.lagged_normal_impulse = normal_impulse(law, velocity, problem.step);
        return pushed(law, velocity, problem.step);
    };
    const Answers answers = answers_by(problem, velocities_after(problem, change), own_limit);
    return residual_of(problem, change, answers, least_speed);
}

}  // namespace enduring
