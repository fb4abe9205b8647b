#include "common/fem/implicit_solver.hpp"

#include "common/fem/mass_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace enduring {
namespace {

/// A factorisation costs about as much as this many iterations (35 to 80,
/// over the bunnies of 363 to 10668 elements).
constexpr int iterations_per_factorisation = 50;
constexpr int early_solves = 5;
constexpr int iteration_limit_fresh = 300;
/// Of a solution that is small beside what it is added to, relative.
constexpr double largest_error = 0.01;

void clear(const std::vector<char>& fixed, NodalVectors& field)
{
    for (Eigen::Index n = 0; n < field.cols(); ++n)
        if (fixed[n])
            field.col(n).setZero();
}

/// The answer to what turns the whole body is that of a rigid one, to the rest that of the factor.
void apply_to_rest(const TurnedFactor& factor, const WholeTurn& turn, double mass_scale,
                   std::span<NodalVectors> fields)
{
    std::vector<Vec3> torques;
    torques.reserve(fields.size());
    for (NodalVectors& field : fields) {
        torques.push_back(turn.torque(field));
        turn.remove_torque(field);
    }
    factor.apply(fields);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        turn.remove_turn(fields[i]);
        turn.add_turn(torques[i] / mass_scale, fields[i]);
    }
}

double dot(const NodalVectors& a, const NodalVectors& b) { return a.reshaped().dot(b.reshaped()); }

}  // namespace

struct ImplicitSolver::System {
    const Elasticity& elasticity;
    const Eigen::SparseMatrix<double>& mass_matrix;
    const std::vector<char>& fixed;
    double mass_scale, stiffness_scale;
    const WholeTurn* turn;

    void clear_fixed(NodalVectors& field) const { clear(fixed, field); }

    void multiply(const NodalVectors& v, NodalVectors& result) const
    {
        result.noalias() = v * mass_matrix;
        result *= mass_scale;
        if (turn)
            add_stiffness_without_turn(v, result);
        else
            elasticity.add_stiffness_times(v, stiffness_scale, result);
        clear_fixed(result);
    }

    //! [without_turn]
    void add_stiffness_without_turn(const NodalVectors& v, NodalVectors& result) const
    {
        NodalVectors strains = v, forces = NodalVectors::Zero(3, v.cols());
        turn->remove_turn(strains);
        elasticity.add_stiffness_times(strains, stiffness_scale, forces);
        turn->remove_torque(forces);
        result += forces;
    }
    //! [without_turn]

    void precondition(const TurnedFactor& factor, const NodalVectors& r, NodalVectors& z) const
    {
        if (turn) {
            std::array<NodalVectors, 1> fields{r};
            apply_to_rest(factor, *turn, mass_scale, fields);
            z = std::move(fields[0]);
        } else {
            factor.apply(r, z);
        }
        clear_fixed(z);  // a node may have been fixed since the factor was made
    }
};

ImplicitSolver::ImplicitSolver(const ElasticMesh& mesh, const Eigen::SparseMatrix<double>& mass_matrix,
                               double tolerance, LinearSolverKind kind)
    : mass_matrix_(mass_matrix), masses_(lumped_masses(mass_matrix)), tolerance_(tolerance),
      factor_(mesh, kind)
{}

void ImplicitSolver::renew_factor(const System& system)
{
    factor_.factor(system.elasticity, mass_matrix_, system.fixed, system.mass_scale, system.stiffness_scale);
    ++factorisations_;
    is_stale_ = false;
    solves_with_factor_ = early_iterations_ = wasted_iterations_ = 0;
}

void ImplicitSolver::account_for_iterations()
{
    if (++solves_with_factor_ <= early_solves)
        early_iterations_ = std::max(early_iterations_, iterations_);
    else
        wasted_iterations_ += std::max(0, iterations_ - early_iterations_);
}

//! [conjugate_gradients]
/// Stops by r.z, the squared error in the norm of the matrix as the preconditioner sees it,
/// against v.rhs, the squared norm of the solution. True if it got there; also true for
/// numbers that are no longer finite, which the step reports.
bool ImplicitSolver::conjugate_gradients(const System& system, const NodalVectors& rhs, NodalVectors& v,
                                         double given, int iteration_limit)
{
    NodalVectors r, z, direction, image;
    system.multiply(v, image);
    const double curvature = dot(v, image);
    const double share = curvature > 0 ? dot(v, rhs) / curvature : 0;  // of the guess: its best multiple
    v *= share;
    r = rhs - share * image;
    system.clear_fixed(r);  // else a factor from before a node was fixed hands on what pushes it
    system.precondition(factor_, r, z);
    direction = z;
    double rz = dot(r, z);
    for (iterations_ = 0; iterations_ < iteration_limit; ++iterations_) {
        const double own = std::abs(dot(v, rhs)), enough = tolerance_ * tolerance_;
        if (!(rz > std::max(enough * own, std::min(enough * given, largest_error * largest_error * own))))
            return true;
        system.multiply(direction, image);
        const double length = rz / dot(direction, image);
        v += length * direction;
        r -= length * image;
        system.precondition(factor_, r, z);
        const double rz_before = std::exchange(rz, dot(r, z));
        direction = z + (rz / rz_before) * direction;
    }
    return false;
}
//! [conjugate_gradients]

void ImplicitSolver::solve(const Elasticity& elasticity, const std::vector<char>& fixed, double mass_scale,
                           double stiffness_scale, const NodalVectors& rhs, NodalVectors& v, double given,
                           const WholeTurn* turn)
{
    const System system{elasticity, mass_matrix_, fixed, mass_scale, stiffness_scale, turn};
    system.clear_fixed(v);
    if (!rhs.allFinite() || !v.allFinite())
        return;  // nothing to be saved here: the step names the body and the vertex

    if (is_stale_ || !factor_.matches(mass_scale, stiffness_scale) ||
        wasted_iterations_ > iterations_per_factorisation)
        renew_factor(system);
    factor_.turn(elasticity.rotations());
    if (!conjugate_gradients(system, rhs, v, given, 2 * iterations_per_factorisation)) {
        renew_factor(system);
        if (!conjugate_gradients(system, rhs, v, given, iteration_limit_fresh))
            throw std::runtime_error("the elastic system did not converge");
    }
    account_for_iterations();

    // A uniform velocity deforms nothing, so what is left of the residual's sum can be taken out exactly.
    if (std::find(fixed.begin(), fixed.end(), 1) == fixed.end())
        v.colwise() += (rhs.rowwise().sum() - v * (mass_scale * masses_)) / (mass_scale * masses_.sum());
    if (turn)  // nor does a turn
        turn->add_turn(turn->torque(rhs) / mass_scale - turn->angular_momentum(v), v);
}

NodalVectors ImplicitSolver::nearly_solved(const std::vector<char>& fixed, NodalVectors rhs,
                                           const WholeTurn* turn) const
{
    NodalVectors v = NodalVectors::Zero(3, rhs.cols());
    if (factorisations_ == 0)
        return v;
    clear(fixed, rhs);
    if (turn) {
        apply_to_rest(factor_, *turn, factor_.mass_scale(), {&rhs, 1});
        return rhs;
    }
    factor_.apply(rhs, v);
    clear(fixed, v);
    return v;
}

void ImplicitSolver::nearly_solve(const std::vector<char>& fixed, std::span<NodalVectors> fields,
                                  const WholeTurn* turn) const
{
    for (NodalVectors& field : fields)
        if (factorisations_ == 0)
            field.setZero();
        else
            clear(fixed, field);
    if (factorisations_ == 0 || fields.empty())
        return;
    if (turn)
        apply_to_rest(factor_, *turn, factor_.mass_scale(), fields);
    else
        factor_.apply(fields);
    for (NodalVectors& field : fields)
        clear(fixed, field);
}

}  // namespace enduring
