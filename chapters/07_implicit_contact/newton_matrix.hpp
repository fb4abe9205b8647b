#pragma once

#include "chapters/07_implicit_contact/block_matrix.hpp"
#include "chapters/07_implicit_contact/contact_problem.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <memory>

namespace enduring {

/// The matrix of Newton's method, A + J^T S J with the stiffening S of each pair, and its factors. It is
/// factored anew where a stiffening has changed, and ordered anew where other bodies touch.
class NewtonMatrix {
public:
    /// Masses and levers are others from here on.
    /// @param solves  how often the same bodies were solved in this step before
    void begin_response(int solves)
    {
        kind_ = Kind::none;
        solves_ = solves;
    }

    /// How often it was solved since the step began: once in each step of Newton's method, whichever loop asks.
    int solves() const { return solves_; }

    /// x of (A + J^T S J) x = b; zero where the matrix cannot be factored.
    /// @param problem      of the same step as in the calls before: masses and levers are the same
    /// @param hessians  S of each pair
    Eigen::VectorXd solve(const ContactProblem& problem, const std::vector<Mat3>& hessians,
                          const Eigen::VectorXd& b);

    /// What the pairs would push if they answered a change of the velocities as straight as the last solve() took
    /// them to: impulses - S J direction.
    /// @param impulses  where the direction begins, three numbers for each pair
    Eigen::VectorXd tangent(const ContactProblem& problem, Eigen::VectorXd impulses,
                            const Eigen::VectorXd& direction) const;

private:
    /// Which factor is the present one.
    enum class Kind { none, dense, sparse };

    bool fits(const std::vector<Mat3>& hessians) const;
    void factor(const ContactProblem& problem);
    void factor_dense(const ContactProblem& problem);
    void factor_sparse(const ContactProblem& problem);
    Eigen::VectorXd solve_dense(const ContactProblem& problem, const Eigen::VectorXd& b) const;
    Eigen::VectorXd solve_with_factor(const ContactProblem& problem, const Eigen::VectorXd& b) const;

    Kind kind_ = Kind::none;
    int solves_ = 0;              ///< in this step
    std::vector<Mat3> hessians_;  ///< of each pair, when it was factored
    std::vector<int> stiff_;      ///< coordinates that a stiff pair moves, ascending
    Eigen::PartialPivLU<Eigen::MatrixXd> dense_lu_;
    BlockMatrix blocks_;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> sparse_;  ///< ordered for the present pattern
};

}  // namespace enduring
