#pragma once

#include "chapters/07_implicit_contact/block_matrix.hpp"
#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "common/fem/linear_solver.hpp"

#include <Eigen/LU>

#include <memory>

namespace enduring {

/// Additions and multiplications of a factor, if each body is eliminated with what it touches of the bodies
/// after it. What this fills in between these is left out.
double estimated_operations(const ContactProblem& problem);

/// A + J^T S J where every pair is pressed and holds, its lower triangle: for measurements.
Eigen::SparseMatrix<double> pressed_matrix(const ContactProblem& problem);

/// The matrix of Newton's method, A + J^T S J with the stiffening S of each pair, and its factors. It is
/// factored anew where a stiffening has changed, and ordered anew where other bodies touch.
class NewtonMatrix {
public:
    /// Masses and levers are others from here on.
    /// @param solves  how often the same bodies were solved in this step before
    void begin_response(int solves)
    {
        has_factor_ = false;
        solves_ = solves;
    }

    /// How often it was solved since the step began: once in each step of Newton's method, whichever loop
    /// asks.
    int solves() const { return solves_; }

    /// x of (A + J^T S J) x = b; zero where the matrix cannot be factored.
    /// @param problem      of the same step as in the calls before: masses and levers are the same
    /// @param hessians  S of each pair
    Eigen::VectorXd solve(const ContactProblem& problem, const std::vector<Mat3>& hessians,
                          const Eigen::VectorXd& b);

    /// What the pairs would push if they answered a change of the velocities as straight as the last solve()
    /// took them to: impulses - S J direction.
    /// @param impulses  where the direction begins, three numbers for each pair
    /// @param rates     of the pairs along the direction
    Eigen::VectorXd tangent(Eigen::VectorXd impulses, const std::vector<Vec3>& rates) const;

private:
    bool fits(const std::vector<Mat3>& hessians) const;
    void factor(const ContactProblem& problem);
    void factor_turns(const ContactProblem& problem);

    bool has_factor_ = false, is_positive_ = false;
    int solves_ = 0;              ///< in this step
    std::vector<Mat3> hessians_;  ///< of each pair, when it was factored
    BlockMatrix blocks_;
    std::unique_ptr<LinearSolver> solver_;  ///< ordered for the present pattern
    Eigen::MatrixXd turns_, turns_solved_;  ///< of bodies with all their nodes, six columns each; solved for
    Eigen::PartialPivLU<Eigen::MatrixXd> turns_factor_;
};

}  // namespace enduring
