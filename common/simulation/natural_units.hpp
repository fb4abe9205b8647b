#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

//! [scale_parts]
/// Every length, speed and time that a solver needs and a scene need not give, as a part of a natural one
/// (below): so a scene in millimetres runs as the same scene in metres does. Each says why it is so large,
/// and what a tenth of it does, and ten times as much.
struct ScaleParts {
    /// Of the length: how deep the load that a pair carries may press it. Nobody sees it. A tenth: springs
    /// are ten times as stiff where loads decide. Ten times: a stack is low by ten thousandths.
    double wanted_depth = 1e-5;
    /// Of the speed: at which a body separates from another one. When it is free it rises by half the
    /// square, 0.6 % of the length. A tenth: it takes ten times as long. Ten times: it jumps by half of its
    /// size.
    double max_depenetration_velocity = 0.11;
    /// Of the largest length, in a step: the change of velocity that counts as an answer at all. A
    /// coordinate is rounded by 1e-16 of the size. A spring of 100 m / dt^2 answers this with 1e-14 in a
    /// step, and ten times that is the tolerance of a millionth. A tenth: rounding is solved for, in vain.
    /// Ten times: slow bodies are answered less sharply. Where bodies have weight, what it does in a step
    /// is more, but for tiny steps.
    double least_answer = 1e-7;
    /// Of the length, in a step: trembling that the energy check ignores; zero without weight
    /// either. Rounding makes less, and nobody sees ten times of it.
    double trembling = 1e-8;
    /// Steps that are the natural time where there is no gravity: only the step tells then how fast a scene
    /// is. A metre and 10 ms make it the time on Earth. A tenth: a body separates ten times as fast. Ten
    /// times: as slowly.
    double weightless_steps = 32;
};
inline constexpr ScaleParts scale_parts;
//! [scale_parts]

/// What lengths, speeds and times are parts of. By default those of a body of one metre on Earth.
struct NaturalUnits {
    double length = 1;    ///< [m]
    double speed = 3.13;  ///< [m/s]: sqrt(g length), or the length in scale_parts.weightless_steps steps
};

/// @param length   [m], positive
/// @param gravity  its magnitude [m/s^2]
/// @param dt       length of a step, which counts only without gravity [s]
NaturalUnits natural_units(double length, double gravity, double dt);

/// The size of the smaller one of a pair's two bodies; a plane has none [m].
double natural_length(const World& world, const Contact& contact);
/// Those of a pair, by that length.
NaturalUnits natural_units(const World& world, const Contact& contact, double dt);

/// At which a pair's bodies separate from inside [m/s].
/// @param of_scene  if it gives one, for all pairs
double max_depenetration_velocity(const World& world, const Contact& contact, std::optional<double> of_scene,
                                  double dt);

}  // namespace enduring
