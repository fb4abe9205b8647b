#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <algorithm>

namespace enduring {
namespace {

using Eigen::VectorXd;

//! [assemble]
/// Adds A + J^T S J to a matrix of zeros. `at(row, column)` is where its blocks are; above its diagonal a
/// symmetric one is left empty.
template <class At>
void assemble(const ContactProblem& problem, const std::vector<Mat3>& stiffenings, bool symmetric,
              const At& at)
{
    for (const BodyBlock& body : problem.blocks) {
        const int size = static_cast<int>(body.mass.rows());
        at(body.first, body.first).template block<Eigen::Dynamic, Eigen::Dynamic>(size, size) += body.mass;
    }
    for (std::size_t pair = 0; pair < problem.rows.size(); ++pair) {
        const Mat3& stiffening = stiffenings[pair];
        if (stiffening.isZero(0))
            continue;
        for (const VertexMotion& other : problem.rows[pair].moving())
            with_fixed_size(other, [&]<class Other>(int column, const Other& other_rate) {
                const auto force = (stiffening * other_rate).eval();
                for (const VertexMotion& one : problem.rows[pair].moving())
                    with_fixed_size(one, [&]<class One>(int row, const One& rate) {
                        constexpr int rows = One::ColsAtCompileTime, columns = Other::ColsAtCompileTime;
                        if (row >= column || !symmetric)
                            at(row, column).template block<rows, columns>().noalias() += rate.transpose() *
                                                                                         force;
                    });
            });
    }
}
//! [assemble]

/// Soft bodies fill the matrix, since each coordinate of one is coupled with all others of it.
bool is_dense(const ContactProblem& problem)
{
    double filled = 0;
    for (const BodyBlock& block : problem.blocks)
        filled += static_cast<double>(block.mass.size());
    return 8 * filled > static_cast<double>(problem.size) * problem.size;
}

}  // namespace

bool NewtonMatrix::fits(const std::vector<Mat3>& stiffenings) const
{
    // A matrix that is wrong by a thousandth leaves a thousandth of the error in each step.
    return kind_ != Kind::none && stiffenings.size() == stiffenings_.size() &&
           std::equal(stiffenings.begin(), stiffenings.end(), stiffenings_.begin(),
                      [](const Mat3& one, const Mat3& other) {
                          return (one - other).squaredNorm() <= 1e-6 * other.squaredNorm();
                      });
}

//! [factor]
void NewtonMatrix::factor(const ContactProblem& problem)
{
    const bool symmetric = std::all_of(stiffenings_.begin(), stiffenings_.end(),
                                       [](const Mat3& s) { return s.isApprox(s.transpose(), 1e-12); });
    if (is_dense(problem))
        factor_dense(problem, symmetric);
    else
        factor_sparse(problem, symmetric);
}

void NewtonMatrix::factor_dense(const ContactProblem& problem, bool symmetric)
{
    dense_.setZero(problem.size, problem.size);
    assemble(problem, stiffenings_, symmetric, [&](int row, int column) {
        return BlockPlace{&dense_(row, column), dense_.rows()};
    });
    kind_ = symmetric ? Kind::dense_symmetric : Kind::dense;
    if (symmetric)
        dense_cholesky_.compute(dense_);
    else
        dense_lu_.compute(dense_);
}

void NewtonMatrix::factor_sparse(const ContactProblem& problem, bool symmetric)
{
    // where a factor is there, its step is the same, and so is its pattern
    if (blocks_.reset(problem))
        is_ordered_ = is_lu_ordered_ = false;
    assemble(problem, stiffenings_, symmetric, [&](int row, int column) { return blocks_.at(row, column); });
    const auto order_once = [&](auto& solver, bool& is_done) {
        if (!is_done)
            solver.analyzePattern(blocks_.matrix());
        is_done = true;
        solver.factorize(blocks_.matrix());
    };
    kind_ = symmetric ? Kind::sparse_symmetric : Kind::sparse;
    if (symmetric)
        order_once(sparse_cholesky_, is_ordered_);
    else
        order_once(sparse_lu_, is_lu_ordered_);
}
//! [factor]

VectorXd NewtonMatrix::solve_with_factor(const VectorXd& b) const
{
    switch (kind_) {
        case Kind::dense_symmetric: return dense_cholesky_.solve(b);
        case Kind::dense: return dense_lu_.solve(b);
        case Kind::sparse_symmetric:
            if (sparse_cholesky_.info() == Eigen::Success)
                return sparse_cholesky_.solve(b);
            break;
        case Kind::sparse:
            if (sparse_lu_.info() == Eigen::Success)
                return sparse_lu_.solve(b);
            break;
        case Kind::none: break;
    }
    return VectorXd::Zero(b.size());
}

VectorXd NewtonMatrix::solve(const ContactProblem& problem, const std::vector<Mat3>& stiffenings,
                             const VectorXd& b)
{
    if (!fits(stiffenings)) {
        stiffenings_ = stiffenings;
        factor(problem);
    }
    const VectorXd x = solve_with_factor(b);
    return x.allFinite() ? x : VectorXd(VectorXd::Zero(b.size()));
}

}  // namespace enduring
