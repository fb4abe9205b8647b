#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Response of discrete penalty forces with the closest point: k delta n dt for every waiting pair, with the
/// depth delta as a distance and n from p to the closest point q, which makes it k (q - p) dt (thesis 5.5).
void push_to_closest_points(const World& world, Contacts& contacts, double stiffness, double dt);

/// What continuous contact is measured against: discrete penalty forces on discrete detection (thesis 5.1),
/// planes included. Every step asks anew which vertices are inside, so nothing can hook and nothing needs to
/// be redefined; but edges do not push, a fast body passes a thin one unseen, and a vertex past the middle is
/// pushed out on the wrong side. No friction.
Solver discrete_solver(const ContactParameters& parameters);

}  // namespace enduring
