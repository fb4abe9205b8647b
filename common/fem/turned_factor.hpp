#pragma once

#include "common/fem/elasticity.hpp"
#include "common/fem/linear_solver.hpp"
#include "common/fem/stiffness_assembly.hpp"

#include <Eigen/SparseCore>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace enduring {

/// A factorisation of A = a M + b K_R that stays useful while the body turns and bends.
///
/// If every element turned by the same W since the matrix was factored, the new matrix is W A W^T exactly.
/// Otherwise this holds nearly, with one W a node: the mean of its elements' turns. (M is the same along
/// every axis, so W M W^T = M.) So W A^-1 W^T, a turn, a solve with the old factor and a turn back,
/// approximates the new inverse, is symmetric and positive definite, and serves conjugate gradients as
/// preconditioner over many steps (the idea of stiffness warping, Mueller et al. 2002, where it cannot harm).
class TurnedFactor {
public:
    TurnedFactor(const ElasticMesh& mesh, LinearSolverKind kind) : mesh_(mesh), kind_(kind) {}

    /// Factors the matrix with the present rotations.
    /// @throws std::runtime_error  the factorisation broke down (out of memory, or masses and stiffness
    ///     without a common scale)
    void factor(const Elasticity& elasticity, const Eigen::SparseMatrix<double>& mass_matrix,
                const std::vector<char>& fixed, double mass_scale, double stiffness_scale);
    /// Is there a factor, of these scales?
    bool matches(double mass_scale, double stiffness_scale) const;
    double operations() const
    {
        return solver_ ? solver_->operations() : 0;
    }                                                  ///< of a factor; 0 before the first
    double mass_scale() const { return mass_scale_; }  ///< a of the factored matrix
    /// Finds every node's turn since then.
    void turn(const ElementRotations& rotations);
    /// z = W A^-1 W^T r.
    void apply(const NodalVectors& r, NodalVectors& z) const;
    /// The same for each of these, in place: faster than one by one.
    void apply(std::span<NodalVectors> fields) const;

private:
    const ElasticMesh& mesh_;
    LinearSolverKind kind_;
    /// with the solver made when it is first needed: not every body is stepped
    std::optional<StiffnessAssembly> assembly_;
    std::unique_ptr<LinearSolver> solver_;
    ElementRotations rotations_when_factored_, rotations_now_;
    std::vector<Mat3> turns_;
    double mass_scale_ = 0, stiffness_scale_ = 0;
};

}  // namespace enduring
