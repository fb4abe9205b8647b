#pragma once

#include "chapters/07_implicit_contact/implicit_particle.hpp"

namespace enduring {

/// How the rest offset of a spring fades that begins at a depth.
struct Fade {
    double keep = 0.9;    ///< what a step leaves of it, at least, in (0, 1)
    double speed = 0.25;  ///< how fast it fades at most [m/s], positive
};

/// What a particle does that begins inside the ground, after some steps.
struct LettingOut {
    ParticleState state;
    double rest_offset;  ///< of its spring, not positive [m]
    double fastest;      ///< its largest velocity upwards after any step [m/s]
    double work;         ///< what the rising ground has done [J]
};

/// Your prediction: the seconds until a particle that begins half a metre deep has less than a millimetre to
/// go, with the fade above and steps of 0.01 s. Not judged; positive.
double predicted_seconds();

/// The rest offset after one step: `keep` times what it was, but never faded faster than `speed`.
/// @param rest_offset  not positive [m]
double faded(double rest_offset, const Fade& fade, double dt);

/// The number of steps until a rest offset is larger than -left, from formulas and not by trying them all.
/// @param rest_offset, left  the first not positive, the second positive [m]
int steps_to_fade(double rest_offset, double left, const Fade& fade, double dt);

/// What a ground does that rises by `rise` in one step while it pushes the particle from one state to the
/// next: its impulse, which the change of the velocity tells, times its speed [J].
double work_of_rising(const ParticleState& before, const ParticleState& after, double rise,
                      const ImplicitParticle& particle);

/// Lets a particle out that begins at rest `depth` below the surface, with a spring whose rest offset is this
/// depth. The spring pushes as a ground does that lies at the height of the rest offset. In each step the
/// rest offset fades, so this ground rises, at the same speed throughout the step; seen from it, the particle
/// makes an implicit step (chapter 7's `step`).
/// @param depth  [m], not negative
LettingOut let_out(double depth, const ImplicitParticle& particle, const Fade& fade, int steps);

}  // namespace enduring
