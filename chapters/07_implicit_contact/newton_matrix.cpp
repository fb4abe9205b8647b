#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include "chapters/07_implicit_contact/block_cholesky.hpp"
#include "common/fem/exact_solver.hpp"

#include <algorithm>
#include <set>

namespace enduring {
namespace {

using Eigen::VectorXd;

/// From here on a factor takes dense blocks. A tenth: both take the same time. Ten times and more: at 20
/// million operations a factor takes 7 ms column by column, and 2.5 ms in blocks.
constexpr double operations_for_blocks = 1e6;

/// Of rigid bodies: from here on the library's large blocks are faster than those of 6 x 6. A tenth: a factor
/// of 300 bricks takes twice as long. Ten times: one of a cube of 7 x 7 x 7 cubes takes 1.4 times as long.
constexpr double operations_for_library = 5e7;

void add_whole(const BodyBlock& body, BlockMatrix& matrix)
{
    for (int column = 0; column < body.size(); ++column) {
        double* place = nullptr;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(body.whole->elastic, column); entry; ++entry) {
            if (!place || entry.row() % 3 == 0)  // the next node
                place = matrix.at(body.first + static_cast<int>(entry.row()), body.first + column).entries;
            *place++ += entry.value();
        }
    }
}

//! [assemble]
/// Adds A + J^T S J to a matrix of zeros. It is symmetric, and above its diagonal it is left empty.
void assemble(const ContactProblem& problem, const std::vector<Mat3>& hessians, BlockMatrix& matrix)
{
    for (const BodyBlock& body : problem.blocks)
        if (body.whole)
            add_whole(body, matrix);
        else
            for (int first = 0, together = coordinates_together(body); first < body.size();
                 first += together) {
                const int rows = body.size() - first, columns = std::min(together, rows);
                matrix.at(body.first + first, body.first + first)
                    .block<Eigen::Dynamic, Eigen::Dynamic>(rows, columns) += body.mass.block(first, first,
                                                                                             rows, columns);
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
                            matrix.at(row, column).template block<rows, columns>().noalias() +=
                                rate.transpose() * force;
                    });
            });
    }
}
//! [assemble]

}  // namespace

//! [estimate]
double estimated_operations(const ContactProblem& problem)
{
    std::vector<std::size_t> body_of(static_cast<std::size_t>(problem.size));
    for (std::size_t body = 0; body < problem.blocks.size(); ++body)
        std::fill_n(body_of.begin() + problem.blocks[body].first, problem.blocks[body].size(), body);
    std::vector<std::set<int>> behind(
        problem.blocks.size());  // of later bodies, the coordinates in touch with each one
    for (const PairRow& row : problem.rows)
        for (const VertexMotion& one : row.moving())
            for (const VertexMotion& other : row.moving()) {
                const std::size_t body = body_of[static_cast<std::size_t>(other.first)];
                if (body < body_of[static_cast<std::size_t>(one.first)])
                    for (int i = 0; i < one.rate.cols(); ++i)
                        behind[body].insert(one.first + i);
            }
    double operations = 0;
    for (std::size_t body = 0; body < problem.blocks.size(); ++body) {
        const double own = problem.blocks[body].size(), later = static_cast<double>(behind[body].size());
        operations += own * (own * own / 3 + own * later + later * later);
    }
    return operations;
}
//! [estimate]

Eigen::SparseMatrix<double> pressed_matrix(const ContactProblem& problem)
{
    std::vector<Mat3> hessians;
    hessians.reserve(problem.rows.size());
    for (const PairRow& row : problem.rows)
        hessians.emplace_back(row.law.stiffness * problem.step.dt * problem.step.dt * Mat3::Identity());
    BlockMatrix blocks;
    blocks.reset(problem);
    blocks.clear();
    assemble(problem, hessians, blocks);
    return blocks.matrix();
}

bool NewtonMatrix::fits(const std::vector<Mat3>& hessians) const
{
    // A matrix that is wrong by a thousandth leaves a thousandth of the error in each step.
    return has_factor_ && hessians.size() == hessians_.size() &&
           std::equal(hessians.begin(), hessians.end(), hessians_.begin(),
                      [](const Mat3& one, const Mat3& other) {
                          return (one - other).squaredNorm() <= 1e-6 * other.squaredNorm();
                      });
}

namespace {

bool is_of_rigid_bodies(const ContactProblem& problem)
{
    return std::all_of(problem.blocks.begin(), problem.blocks.end(), [](const BodyBlock& body) {
        return !body.whole && (body.size() == 0 || body.size() == BlockCholesky::side);
    });
}

//! [solver_for]
std::unique_ptr<LinearSolver> solver_for(const ContactProblem& problem,
                                         const Eigen::SparseMatrix<double>& pattern)
{
    if (is_of_rigid_bodies(problem)) {
        auto blocks = std::make_unique<BlockCholesky>(pattern);
        if (!has_supernodal_solver() || blocks->operations() < operations_for_library)
            return blocks;
    }
    return estimated_operations(problem) > operations_for_blocks
               ? make_exact_solver(pattern)
               : make_linear_solver(LinearSolverKind::simplicial, pattern);
}
//! [solver_for]

}  // namespace

//! [factor]
void NewtonMatrix::factor(const ContactProblem& problem)
{
    // where a factor is there, its step is the same, and so is its pattern
    const bool is_other_pattern = !has_factor_ && blocks_.reset(problem);
    blocks_.clear();
    assemble(problem, hessians_, blocks_);
    if (!has_factor_ && (is_other_pattern || !solver_))
        solver_ = solver_for(problem, blocks_.matrix());
    is_positive_ = solver_->factor(blocks_.matrix());
    has_factor_ = true;
    factor_turns(problem);
}
//! [factor]

//! [turns]
/// What is taken out of K against turns, - b (G U^T + U G^T) = W C W^T with W = (G U), has rank 6 a body: (B
/// + W C W^T)^-1 is B^-1 - B^-1 W (C^-1 + W^T B^-1 W)^-1 W^T B^-1 with the B that is factored (Woodbury).
void NewtonMatrix::factor_turns(const ContactProblem& problem)
{
    Eigen::Index columns = 0;
    for (const BodyBlock& block : problem.blocks)
        columns += block.whole ? block.whole->turn.cols() : 0;
    turns_ = Eigen::MatrixXd::Zero(problem.size, columns);
    Eigen::MatrixXd small = Eigen::MatrixXd::Zero(columns, columns);
    columns = 0;
    for (const BodyBlock& block : problem.blocks)
        if (block.whole && block.whole->turn.cols() > 0) {
            turns_.block(block.first, columns, block.size(), 6) = block.whole->turn;
            const Mat3 inverse = -1 / block.whole->stiffness_scale * Mat3::Identity();
            small.block<3, 3>(columns, columns + 3) = small.block<3, 3>(columns + 3, columns) = inverse;
            columns += 6;
        }
    if (columns == 0 || !is_positive_)
        return;
    turns_solved_ = turns_;
    solver_->solve(turns_solved_);
    turns_factor_.compute(small + turns_.transpose() * turns_solved_);
}
//! [turns]

//! [tangent]
VectorXd NewtonMatrix::tangent(VectorXd impulses, const std::vector<Vec3>& rates) const
{
    for (std::size_t i = 0; i < rates.size(); ++i)
        if (!hessians_[i].isZero(0))
            impulses.segment<3>(static_cast<Eigen::Index>(3 * i)) -= hessians_[i] * rates[i];
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
    VectorXd x = b;
    if (is_positive_)
        solver_->solve(x);
    if (is_positive_ && turns_.cols() > 0)
        x -= turns_solved_ * turns_factor_.solve(turns_.transpose() * x);
    return is_positive_ && x.allFinite() ? x : VectorXd(VectorXd::Zero(b.size()));
}

}  // namespace enduring
