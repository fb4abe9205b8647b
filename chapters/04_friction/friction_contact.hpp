#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Response, after the normal impulses: gives every waiting pair that pushes its friction impulse. All come
/// from the same prediction, and the step applies them together with the normal ones.
/// @param dt  length of the step [s], positive
/// @see thesis 5.3
void compute_friction_impulses(const World& world, Contacts& contacts, const FrictionParameters& friction,
                               double dt);

/// Finish, from the last prediction: every anchor turns with the surface that it sits on, and the point that
/// it holds moves on along that surface, a new pair's from its time of impact. A pair that no longer pushes
/// has no anchor; one that is held only turns its own.
/// @param dt  length of the step [s], positive
void move_friction_anchors(const World& world, Contacts& contacts, const FrictionParameters& friction,
                           double dt);

/// Appends this chapter's passes to a solver whose last response passes give the normal impulses.
void add_friction(Solver& solver, const FrictionParameters& friction);

}  // namespace enduring
