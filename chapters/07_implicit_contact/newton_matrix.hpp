#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"

#include <Eigen/SparseCholesky>

#include <functional>

namespace enduring {

/// The matrix of Newton's method for the problems of one step, A + J^T S J with the stiffening S of each
/// pair, and its factors. It is factored anew where a stiffening has changed.
class NewtonMatrix {
public:
    /// x of (A + J^T S J) x = b; zero where the matrix cannot be factored.
    /// @param change  of the predicted velocities, where S is taken
    /// @param problem  of the same step as in the calls before: masses and levers are the same
    Eigen::VectorXd solve(const ContactProblem& problem, const Eigen::VectorXd& change,
                          const Eigen::VectorXd& b);

private:
    bool fits(const std::vector<Mat3>& stiffenings) const;
    void factor(const ContactProblem& problem);

    std::vector<Mat3> stiffenings_;  ///< of each pair, when it was factored
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> solve_;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> sparse_;
    bool is_analysed_ = false;  ///< the pattern of the sparse matrix, which is that of the step
};

}  // namespace enduring
