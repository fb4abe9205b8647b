#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <algorithm>

namespace enduring {
namespace {

using Eigen::VectorXd;

//! [assemble]
/// Adds A + J^T S J to a matrix of zeros. `at(row, column)` is where its blocks are. It is symmetric, and above its diagonal
/// it is left empty.
template <class At>
void assemble(const ContactProblem& problem, const std::vector<Mat3>& hessians, const At& at)
{
    for (const BodyBlock& body : problem.blocks) {
        const int size = static_cast<int>(body.mass.rows());
        at(body.first, body.first).template block<Eigen::Dynamic, Eigen::Dynamic>(size, size) += body.mass;
    }
    for (std::size_t pair = 0; pair < problem.rows.size(); ++pair) {
        const Mat3& hessian = hessians[pair];
        if (hessian.isZero(0))
            continue;
        for (const VertexMotion& other : problem.rows[pair].moving())
            with_fixed_size(other, [&]<class Other>(int column, const Other& other_rate) {
                const auto force = (hessian * other_rate).eval();
                for (const VertexMotion& one : problem.rows[pair].moving())
                    with_fixed_size(one, [&]<class One>(int row, const One& rate) {
                        constexpr int rows = One::ColsAtCompileTime, columns = Other::ColsAtCompileTime;
                        if (row >= column)
                            at(row, column).template block<rows, columns>().noalias() += rate.transpose() *
                                                                                         force;
                    });
            });
    }
}
//! [assemble]

/// Soft bodies fill the matrix, since each coordinate of one is coupled with all others of it. Rigid bodies do not, even
/// where they are few.
bool is_dense(const ContactProblem& problem)
{
    constexpr int of_rigid_body = 6;
    double filled = 0;
    for (const BodyBlock& block : problem.blocks)
        if (block.size() > of_rigid_body)
            filled += static_cast<double>(block.mass.size());
    return 8 * filled > static_cast<double>(problem.size) * problem.size;
}

std::vector<int> stiff_coordinates(const ContactProblem& problem, const std::vector<Mat3>& hessians)
{
    std::vector<char> is_stiff(static_cast<std::size_t>(problem.size), 0);
    for (std::size_t pair = 0; pair < problem.rows.size(); ++pair)
        if (!hessians[pair].isZero(0))
            for (const VertexMotion& part : problem.rows[pair].moving())
                std::fill_n(is_stiff.begin() + part.first, part.rate.cols(), 1);
    std::vector<int> stiff;
    for (int coordinate = 0; coordinate < problem.size; ++coordinate)
        if (is_stiff[static_cast<std::size_t>(coordinate)])
            stiff.push_back(coordinate);
    return stiff;
}

/// A^-1 of some coordinates, which are ascending.
Eigen::MatrixXd response_among(const ContactProblem& problem, const std::vector<int>& coordinates)
{
    const auto size = static_cast<Eigen::Index>(coordinates.size());
    Eigen::MatrixXd response = Eigen::MatrixXd::Zero(size, size);
    for (const BodyBlock& block : problem.blocks) {
        const auto first = std::lower_bound(coordinates.begin(), coordinates.end(), block.first),
                   last = std::lower_bound(first, coordinates.end(), block.first + block.size());
        std::vector<int> own(first, last);
        for (int& coordinate : own)
            coordinate -= block.first;
        const auto place = first - coordinates.begin(), count = last - first;
        response.block(place, place, count, count) = block.response(own, own);
    }
    return response;
}

}  // namespace

bool NewtonMatrix::fits(const std::vector<Mat3>& hessians) const
{
    // A matrix that is wrong by a thousandth leaves a thousandth of the error in each step.
    return kind_ != Kind::none && hessians.size() == hessians_.size() &&
           std::equal(hessians.begin(), hessians.end(), hessians_.begin(),
                      [](const Mat3& one, const Mat3& other) {
                          return (one - other).squaredNorm() <= 1e-6 * other.squaredNorm();
                      });
}

//! [factor]
void NewtonMatrix::factor(const ContactProblem& problem)
{
    if (is_dense(problem))
        factor_dense(problem);
    else
        factor_sparse(problem);
}

void NewtonMatrix::factor_sparse(const ContactProblem& problem)
{
    // where a factor is there, its step is the same, and so is its pattern
    const bool is_other_pattern = blocks_.reset(problem);
    assemble(problem, hessians_, [&](int row, int column) { return blocks_.at(row, column); });
    if (is_other_pattern)
        sparse_.analyzePattern(blocks_.matrix());
    sparse_.factorize(blocks_.matrix());
    kind_ = Kind::sparse;
}
//! [factor]

//! [factor_dense]
/// With momenta p for unknowns, x = A^-1 p, the matrix is I + K A^-1, K = J^T S J. Where no stiff pair is, K has
/// neither rows nor columns: there p = b, and what is left to be factored is small.
void NewtonMatrix::factor_dense(const ContactProblem& problem)
{
    kind_ = Kind::dense;
    stiff_ = stiff_coordinates(problem, hessians_);
    const Eigen::MatrixXd response = response_among(problem, stiff_);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(response.rows(), response.cols());
    const auto place = [&](int coordinate) {
        return std::lower_bound(stiff_.begin(), stiff_.end(), coordinate) - stiff_.begin();
    };
    Eigen::Matrix3Xd force(3, response.cols());  // of a pair, for a unit momentum of each coordinate
    for (std::size_t pair = 0; pair < problem.rows.size(); ++pair) {
        if (hessians_[pair].isZero(0))
            continue;
        force.setZero();
        for (const VertexMotion& part : problem.rows[pair].moving())
            with_fixed_size(part, [&]<class Motion>(int first, const Motion& motion) {
                const auto stiff = (hessians_[pair] * motion).eval();
                for (Eigen::Index column = 0, row = place(first); column < force.cols(); ++column)
                    force.col(column).noalias() +=
                        stiff * response.col(column).template segment<Motion::ColsAtCompileTime>(row);
            });
        for (const VertexMotion& part : problem.rows[pair].moving())
            with_fixed_size(part, [&]<class Motion>(int first, const Motion& motion) {
                for (Eigen::Index column = 0, row = place(first); column < force.cols(); ++column)
                    matrix.col(column).template segment<Motion::ColsAtCompileTime>(row).noalias() +=
                        motion.transpose() * force.col(column);
            });
    }
    dense_lu_.compute(matrix);
}

VectorXd NewtonMatrix::solve_dense(const ContactProblem& problem, const VectorXd& b) const
{
    const VectorXd without = times_response(problem, b);
    VectorXd pushed = VectorXd::Zero(b.size());  // by the pairs' stiffness, for x of no pairs
    for (std::size_t pair = 0; pair < problem.rows.size(); ++pair)
        if (!hessians_[pair].isZero(0)) {
            const PairRow& row = problem.rows[pair];
            row.add_impulse(-(hessians_[pair] * row.rate_of(without)), pushed);
        }
    VectorXd momentum = b;
    momentum(stiff_) += dense_lu_.solve(pushed(stiff_));
    return times_response(problem, momentum);
}
//! [factor_dense]

VectorXd NewtonMatrix::solve_with_factor(const ContactProblem& problem, const VectorXd& b) const
{
    switch (kind_) {
        case Kind::dense: return solve_dense(problem, b);
        case Kind::sparse:
            if (sparse_.info() == Eigen::Success)
                return sparse_.solve(b);
            break;
        case Kind::none: break;
    }
    return VectorXd::Zero(b.size());
}

//! [tangent]
VectorXd NewtonMatrix::tangent(const ContactProblem& problem, VectorXd impulses,
                               const VectorXd& direction) const
{
    for (std::size_t i = 0; i < problem.rows.size(); ++i)
        if (!hessians_[i].isZero(0))
            impulses.segment<3>(static_cast<Eigen::Index>(3 * i)) -= hessians_[i] *
                                                                     problem.rows[i].rate_of(direction);
    return impulses;
}
//! [tangent]

VectorXd NewtonMatrix::solve(const ContactProblem& problem, const std::vector<Mat3>& hessians,
                             const VectorXd& b)
{
    if (!fits(hessians)) {
        hessians_ = hessians;
        factor(problem);
    }
    ++solves_;
    const VectorXd x = solve_with_factor(problem, b);
    return x.allFinite() ? x : VectorXd(VectorXd::Zero(b.size()));
}

}  // namespace enduring
