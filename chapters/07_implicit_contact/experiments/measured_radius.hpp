#pragma once

#include "chapters/07_implicit_contact/implicit_particle.hpp"

namespace enduring::chapter07 {

/// The particle with h = k dt^2 / m, of 1 kg and steps of 0.01 s.
ImplicitParticle particle_with(double h, double centre, PositionUpdate update = PositionUpdate::end_velocity);

/// The spectral radius of a step near rest, read off four heights of a simulation without the matrix.
double measured_radius(const ImplicitParticle& problem);

/// Does a particle dropped from `drop_height` [m] come to rest: do its
/// heights stay within a millionth of m g / k?
bool settles(const ImplicitParticle& problem, double drop_height, int steps = 40000);

}  // namespace enduring::chapter07
