#pragma once

#include "chapters/01_particle_plane/particle.hpp"

#include <Eigen/Core>

namespace enduring {

/// Where in the step a method finds the depth, for a particle that is inside throughout: 1 for DPF, which
/// looks at the end, and 1/2 for CPF, whose mean of a linear depth is that in the middle. All of this
/// chapter's numbers follow from it.
double look_ahead(PenaltyMethod method);

/// The matrix A of one step for a particle that is inside the ground throughout: (x, v) of the step's end
/// from those of its start, measured from rest, where gravity drops out (thesis 7.7 and 7.11).
Eigen::Matrix2d amplification(PenaltyMethod method, double mass, double stiffness, double dt);

/// Largest modulus of an eigenvalue of a 2x2 matrix.
double spectral_radius(const Eigen::Matrix2d& a);

/// The step [s] up to which the spectral radius stays below 1, h = k dt^2 / m up to 4 / (1 + 2 look_ahead):
/// sqrt(4m/3k) for DPF, sqrt(2m/k) for CPF (thesis 7.1.1).
double critical_step(PenaltyMethod method, double mass, double stiffness);

/// How a small oscillation about rest decays, read off A's eigenvalues rho exp(+-i theta).
struct Decay {
    double per_step = 0;           ///< rho, factor on the amplitude a step
    double steps_per_contact = 0;  ///< pi / theta, half a swing
    /// rho^(pi/theta): an estimate of how much of its speed a bounce gives back
    double per_contact = 0;
};

/// @throws std::domain_error  the eigenvalues are real: nothing swings
Decay decay(const Eigen::Matrix2d& a);

}  // namespace enduring
