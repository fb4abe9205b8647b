#pragma once

#include <Eigen/SparseCore>

#include <filesystem>
#include <optional>

namespace enduring {

/// How impulses at contacts change the velocities of bodies: M v = f + H r, u = H^T v + w.
struct BodyEquations {
    Eigen::SparseMatrix<double> mass;    ///< M, symmetric and positive definite
    Eigen::SparseMatrix<double> levers;  ///< H: a column for each number of r
    Eigen::VectorXd force;               ///< f, as an impulse
    Eigen::VectorXd given_velocity;      ///< w, of what moves by itself
};

/// One step of rigid contact with Coulomb's friction, as the public collections have it: r and u have
/// `dimension` numbers for each contact, the first along its normal, and between them holds
///   u = W r + q,   0 <= u_n, 0 <= r_n, u_n r_n = 0,   |r_t| <= mu r_n,
///   and r_t against u_t with |r_t| = mu r_n where u_t is not 0.
/// V. Acary, M. Bremond, T. Koziara, F. Perignon: FCLIB: a collection of discrete 3D frictional contact
/// problems, INRIA technical report 444, 2014.
struct FrictionProblem {
    int dimension = 3;                     ///< 2 or 3
    Eigen::SparseMatrix<double> response;  ///< W; where `bodies` are given, H^T M^-1 H
    Eigen::VectorXd free_velocity;         ///< q; where `bodies` are given, H^T M^-1 f + w
    Eigen::VectorXd mu;                    ///< of each contact
    std::optional<BodyEquations> bodies;   ///< where the file has them ("global")

    int contacts() const { return static_cast<int>(mu.size()); }
};

/// The velocities of all contacts by these impulses: W r + q.
Eigen::VectorXd contact_velocities(const FrictionProblem& problem, const Eigen::VectorXd& impulses);

/// Checks sizes, signs and symmetry, and fills W and q from the equations of bodies.
/// @param file  named in messages
/// @throws InputError
void complete(FrictionProblem& problem, const std::filesystem::path& file);

}  // namespace enduring
