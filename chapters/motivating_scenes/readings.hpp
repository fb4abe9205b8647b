#pragma once

#include "chapters/motivating_scenes/motivating_scene.hpp"

namespace enduring::motivating {

// What the motivating scenes are measured by. Each sees all steps of a run, and ends with what a row of the
// failure ledger shows.

/// None where there is nothing to measure.
using Value = std::optional<double>;

/// How far the lowest vertex of all bodies is below the ground at the end [mm].
void below_ground(Value& value, const World& world, const Contacts&, double dt);

/// Most pairs of features that were in the list after a step.
void max_pairs(Value& value, const World&, const Contacts& contacts, double dt);

/// Height of a body's middle at the end [m].
Gauge::Reading height_of(const std::string& body);

/// The same for a body that has to be held up at first: none if it is below a height [m] before a time [s].
Gauge::Reading height_after_being_held(const std::string& body, double above, double until);

/// Share of pairs that are labelled as they should be, over the whole run [%]. On a flat floor it is known
/// how: a pair that pushes along the floor is hooked, one that pushes upwards is regular.
Gauge::Reading right_labels();

/// Longest lever of a pushing pair over the run [mm].
void longest_of_levers(Value& value, const World& world, const Contacts& contacts, double dt);

/// Deepest vertex over the run that nothing pushes out [mm].
Gauge::Reading deepest_unpushed(const std::string& of, const std::string& in);

/// A body's speed along x at the end [m/s], unless it has fallen through the floor.
Gauge::Reading speed_on_floor(const std::string& body);

/// Kinetic energy at the end over that at the start, once it has bounced back.
Gauge::Reading energy_after_bounce(const std::string& body);

/// How far a body moves in the last second [mm].
Gauge::Reading drift_after(const std::string& body, double time);

/// How far the way that a block comes up a slope departs from v^2 / (2 g (sin + mu_d cos)) [%], once it lies
/// still.
/// @param exact  way by that formula [m]
Gauge::Reading error_of_way(const std::string& body, double exact);

/// How far above its floor, at height 0, the lowest vertex of a body comes [mm], unless it is in the floor at
/// the end.
Gauge::Reading highest_over_floor(const std::string& body);

/// Most energy that a tower has over that at a time [J], from then on, unless its last cube has come down by
/// half of itself.
Gauge::Reading energy_gained_after(double time, const std::string& last, double lowest_height);

/// Kinetic energy at the end over that at the start, unless the body's middle is below height 0.
Gauge::Reading energy_if_above(const std::string& body);

/// How far the two ends of a joint were apart over the run [mm], of all joints, whether the solver has joints
/// or not.
void gap_of_joints(Value& value, const World& world, const Contacts&, double dt);

/// Most edges of a body that passed, after a step, through faces that were `apart` from them at first [m],
/// unless the body still stands higher than `standing` [m]. Surfaces that are pressed into each other by less
/// than a millimetre do not cross.
Gauge::Reading edges_through(const std::string& body, double apart, double standing);

}  // namespace enduring::motivating
