#pragma once

#include "chapters/01_particle_plane/particle.hpp"

#include <vector>

namespace enduring {

/// How long to watch a dropped particle, and when to call it at rest.
struct SettlingTest {
    double drop_height = 0.1;  ///< from where it falls, at velocity 0 [m]
    int steps = 20000;         ///< until the judgement
    int watched = 200;         ///< last steps that count
    double tolerance = 1e-6;   ///< of m g / k: the largest swing of the watched heights that is called rest
};

/// The heights of the last `watched` steps [m].
std::vector<double> last_heights(const ParticleProblem& problem, const SettlingTest& test = {});

/// Highest minus lowest of the watched heights [m].
double last_swing(const ParticleProblem& problem, const SettlingTest& test = {});

/// Does the particle come to rest? Asked instead of "does it blow up?": the ground
/// never pulls, so an unstable contact throws the particle off, it falls back, and the
/// motion stays bounded well above the critical step.
bool settles(const ParticleProblem& problem, const SettlingTest& test = {});

/// The largest step [s] with which the particle settles, by bisection
/// between one that does and one that does not.
/// @param relative_width  of the bracket at the end
/// @throws std::logic_error  the bracket [low, high] does not hold the change from settling to not settling
double measured_critical_step(ParticleProblem problem, double low, double high, double relative_width = 1e-4,
                              const SettlingTest& test = {});

}  // namespace enduring
