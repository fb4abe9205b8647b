#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"

namespace enduring::chapter08 {

/// A top of 0.5 kg, two cones base to base, that spins on its lower tip and leans. Friction holds the tip.
struct Top {
    double spin = 60;      ///< about its axis, the turn of the axis included [rad/s]
    double lean_deg = 20;  ///< of its axis from upright
    double dt = 0.002;     ///< [s]
    int sides = 24;        ///< of the cones
};

/// How its axis goes round.
struct Precession {
    double rate = 0, by_formula = 0;  ///< [rad/s]
    double lean_change_deg = 0;       ///< at the end, against the start
    double energy_change = 0;         ///< at the end, over the kinetic energy at the start
    double tip_moved_mm = 0;          ///< at the end
    chapter07::SolveStatistics solves;
};

/// Rate of the slow steady precession, from the moment of the weight about the tip:
///   A cos(lean) rate^2 - C spin rate + m g l = 0,
/// with the moments of inertia A across the axis at the tip and C about the axis (Goldstein, Classical
/// Mechanics, 5.7).
/// @param across, along  A and C [kg m^2]
/// @param moment         m g l [N m], l from the tip to the centre of mass
/// @param lean           [rad]
/// @throws InputError    a top so slow that it has no steady precession
double steady_precession(double across, double along, double moment, double spin, double lean);

/// Begins in steady precession and measures it.
/// @param duration  [s]
Precession spin_top(const Top& top, double duration);

}  // namespace enduring::chapter08
