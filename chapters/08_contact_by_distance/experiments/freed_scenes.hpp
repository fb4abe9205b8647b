#pragma once

#include "chapters/08_contact_by_distance/experiments/driven_scenes.hpp"

#include <string>

namespace enduring::chapter08 {

/// A puck on the ground, pulled by a spring from rest: where it turns first, at 2 mu m g / k less than where
/// it began, on the other side [m].
AgainstFormula puck_on_spring(double dt);

/// A pin that goes round in a circle slides in the slot of a yoke, which can only move along an axis (a
/// Scotch yoke): where the yoke is when it is farthest from r cos(omega t), in two turns [m].
AgainstFormula pin_in_slot(double dt);

/// A soft bar, free, under a force at each end: the angle by which it has turned, T t^2 / (2 I) [rad].
AgainstFormula turned_by_two_forces(double dt);

/// A soft bar is clamped, turned at its other end, and let go.
struct LetGo {
    AgainstFormula period;  ///< of its swings, 4 L / sqrt(G J / (rho I_p)) [s]
    double most_held;       ///< energy afterwards, relative to that held when it is let go
};
struct TwistedBar {
    double turn_deg = 360;
    int along = 16, across = 2;  ///< cells
    std::string basis = "quadratic";
};
LetGo twisted_and_let_go(double dt, const TwistedBar& of_bar = {});

}  // namespace enduring::chapter08
