#pragma once

#include "chapters/07_implicit_contact/pair_law.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"

#include <optional>

namespace enduring {

/// A surface with a grain holds less along one direction than across it. What it can hold is an ellipse, and
/// what a pair gets that slips is the impulse of this ellipse that takes the most energy (exercise 4.2).
///
/// A stretch D makes the ellipse of the circle: friction is D^T g, where g is the friction of an equal
/// surface that slips with D u. The potential of g is convex in D u, so that of friction is convex in u.

/// The stretch D of a pair: 1 along the grain, Grain::across at right angles to it. On two surfaces with a
/// grain both stretch, A's first. None where no surface has one, or its direction is the normal.
std::optional<Mat3> grain_of(const World& world, const Contact& contact, const Vec3& normal);

/// What the spring of the equal surface is stretched by [m].
/// @param stretch  of the pair at the start, by its force: D^T g = -k stretch
/// @param moved    of p against q in the step
Vec3 stretch_on_grain(const Mat3& grain, const Vec3& stretch, const Vec3& moved);

}  // namespace enduring
