#pragma once

#include "chapters/07_implicit_contact/implicit_particle.hpp"

#include <Eigen/Core>

namespace enduring {

/// The matrix of one implicit step for a particle that stays inside: (x, v) of the step's end from those of
/// its start, measured from rest.
Eigen::Matrix2d amplification(const ImplicitParticle& problem);

/// h = k dt^2 / m below which a step that moves by its end's velocity is stable: 4 / (1 - 2 centre), and
/// without end from centre = 1/2 on. Chapter 1's limit with the sign of the place turned round.
double stable_below(double centre);

/// The h at which both eigenvalues meet, 4 / (1 - centre)^2: there a
/// swing dies out fastest. Infinite for centre = 1.
double fastest_stiffness(double centre);

/// What is left of a departure after one step there, -(1 - centre) / (1 +
/// centre): for CPF a third, on the other side.
double fastest_factor(double centre);

/// The eigenvalue that stays when k grows without end, 1 - 1 / centre:
/// for CPF -1, a ring that does not die out.
double ringing_factor(double centre);

}  // namespace enduring
