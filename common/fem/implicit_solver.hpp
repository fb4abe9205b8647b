#pragma once

#include "common/fem/turned_factor.hpp"
#include "common/fem/whole_turn.hpp"

namespace enduring {

/// Solves (a M + b K_R) v = rhs by conjugate gradients, with a
/// factorisation from an earlier step as preconditioner.
///
/// The matrix itself is never built for this: the product runs over the elements. A new factor is made when a
/// or b changes, and when the iterations that a fresh one would have saved add up to the cost of making it.
/// All of it depends on counts, never on a clock: the same input gives the same bits. What a fresh factor
/// would have taken is what the present one took in its first few solves (its very first is always quick,
/// since there nothing has turned yet).
class ImplicitSolver {
public:
    /// @param mass_matrix  M, one row a node; outlives the solver
    /// @param tolerance    stop when the error, in the norm of the matrix,
    ///     is this small relative to the solution
    /// @param kind         of linear solver, which makes the factor and applies it
    ImplicitSolver(const ElasticMesh& mesh, const Eigen::SparseMatrix<double>& mass_matrix, double tolerance,
                   LinearSolverKind kind);

    /// @param elasticity      linear about the start of this step
    /// @param fixed           one flag a node: its velocity is zero whatever rhs says
    /// @param mass_scale      a > 0
    /// @param stiffness_scale b >= 0
    /// @param rhs             [N s]
    /// @param v               a first guess, and the solution on return [m/s]; without fixed nodes its linear
    ///                        momentum is exact to rounding, whatever the tolerance
    /// @param given           solution times rhs of what this one is added to: an error that is small for
    ///                        both together is small enough
    /// @param turn            if any, K is taken without what it holds against a turn of the whole body, and
    ///                        the angular momentum of the solution is exact to rounding, too
    /// @throws std::runtime_error  no convergence even with a fresh factor
    void solve(const Elasticity& elasticity, const std::vector<char>& fixed, double mass_scale,
               double stiffness_scale, const NodalVectors& rhs, NodalVectors& v, double given = 0,
               const WholeTurn* turn = nullptr);

    /// The next solve makes a new factor: a node that was fixed is free, and the old factor answers nothing
    /// there.
    void forget_factor() { is_stale_ = true; }

    /// One application of the preconditioner: the solution for rhs but for what elements have turned against
    /// each other since the matrix was factored, and for its single precision. Zero before the first solve.
    /// @param fixed  as for solve(), and turn, too
    NodalVectors nearly_solved(const std::vector<char>& fixed, NodalVectors rhs,
                               const WholeTurn* turn = nullptr) const;
    /// The same for each of these, in place and in one passage through the factor.
    void nearly_solve(const std::vector<char>& fixed, std::span<NodalVectors> fields,
                      const WholeTurn* turn = nullptr) const;

    /// Additions and multiplications of a factor; 0 before the first one.
    double factor_operations() const { return factor_.operations(); }
    int iterations() const { return iterations_; }          ///< of the last solve
    int factorisations() const { return factorisations_; }  ///< of all so far

private:
    struct System;
    bool conjugate_gradients(const System& system, const NodalVectors& rhs, NodalVectors& v, double given,
                             int iteration_limit);
    void renew_factor(const System& system);
    void account_for_iterations();

    const Eigen::SparseMatrix<double>& mass_matrix_;
    Eigen::VectorXd masses_;  ///< its row sums
    double tolerance_;
    TurnedFactor factor_;
    bool is_stale_ = false;
    int iterations_ = 0, factorisations_ = 0;
    int solves_with_factor_ = 0;
    int early_iterations_ = 0;   ///< the most that one of the first solves with the present factor took
    int wasted_iterations_ = 0;  ///< beyond that, since
};

}  // namespace enduring
