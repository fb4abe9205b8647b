#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>

#include <algorithm>
#include <memory>

namespace enduring {
namespace {

using Eigen::VectorXd;

/// Hands each block of A + J^T S J to `add(row, column, block)`.
template <class Add>
void for_each_block(const ContactProblem& problem, const std::vector<Mat3>& stiffenings, const Add& add)
{
    for (const BodyBlock& block : problem.blocks)
        add(block.first, block.first, block.mass);
    for (std::size_t pair = 0; pair < problem.rows.size(); ++pair) {
        const PairRow& row = problem.rows[pair];
        for (int i = 0; i < row.part_count; ++i)
            for (int j = 0; j < row.part_count; ++j) {
                const VertexMotion &one = row.parts[static_cast<std::size_t>(i)],
                                   &other = row.parts[static_cast<std::size_t>(j)];
                add(one.first, other.first, (one.rate.transpose() * stiffenings[pair] * other.rate).eval());
            }
    }
}

Eigen::MatrixXd dense_matrix(const ContactProblem& problem, const std::vector<Mat3>& stiffenings)
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(problem.size, problem.size);
    for_each_block(problem, stiffenings, [&](int row, int column, const auto& block) {
        matrix.block(row, column, block.rows(), block.cols()) += block;
    });
    return matrix;
}

Eigen::SparseMatrix<double> sparse_matrix(const ContactProblem& problem, const std::vector<Mat3>& stiffenings)
{
    std::vector<Eigen::Triplet<double>> entries;
    for_each_block(problem, stiffenings, [&](int row, int column, const auto& block) {
        for (Eigen::Index j = 0; j < block.cols(); ++j)
            for (Eigen::Index i = 0; i < block.rows(); ++i)
                entries.emplace_back(row + static_cast<int>(i), column + static_cast<int>(j), block(i, j));
    });
    Eigen::SparseMatrix<double> matrix(problem.size, problem.size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

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
    return solve_ && stiffenings.size() == stiffenings_.size() &&
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
    if (is_dense(problem)) {
        const Eigen::MatrixXd matrix = dense_matrix(problem, stiffenings_);
        if (symmetric)
            solve_ = [factor = matrix.llt()](const VectorXd& b) { return VectorXd(factor.solve(b)); };
        else
            solve_ = [factor = matrix.lu()](const VectorXd& b) { return VectorXd(factor.solve(b)); };
        return;
    }
    const Eigen::SparseMatrix<double> matrix = sparse_matrix(problem, stiffenings_);
    if (symmetric) {
        if (!is_analysed_)
            sparse_.analyzePattern(matrix);
        is_analysed_ = true;
        sparse_.factorize(matrix);
        solve_ = [this](const VectorXd& b) { return VectorXd(sparse_.solve(b)); };
    } else {
        using Factor = Eigen::SparseLU<Eigen::SparseMatrix<double>>;
        solve_ = [factor = std::make_shared<Factor>(matrix)](const VectorXd& b) {
            return factor->info() == Eigen::Success ? VectorXd(factor->solve(b)) : VectorXd::Zero(b.size());
        };
    }
}
//! [factor]

VectorXd NewtonMatrix::solve(const ContactProblem& problem, const VectorXd& change, const VectorXd& b)
{
    std::vector<Mat3> stiffenings;
    for (const PairRow& row : problem.rows)
        stiffenings.push_back(answer(row.law, row.velocity_after(change), problem.step).stiffening);
    if (!fits(stiffenings)) {
        stiffenings_ = std::move(stiffenings);
        factor(problem);
    }
    const VectorXd x = solve_(b);
    return x.allFinite() ? x : VectorXd(VectorXd::Zero(b.size()));
}

}  // namespace enduring
