#pragma once

#include "common/simulation/step.hpp"

#include <optional>

namespace enduring::motivating {

/// How deep a point lies in a body with a closed surface, at the committed state
/// [m]: its distance to the nearest face, or 0 where it is outside. From inside the
/// faces are seen all around, under a solid angle of 4 pi.
double depth_inside(const Body& body, const Vec3& point);

/// The deepest vertex of A that lies in B while nothing pushes it out: no vertex-face pair of it with B is in
/// the list, or only one that is held.
/// @param body_a, body_b  indices into World::bodies; B has a closed surface
/// @return  its depth [m], 0 if there is none
double deepest_without_pair(const World& world, const Contacts& contacts, int body_a, int body_b);

/// Longest distance along the surface between the two points of a vertex-face pair that pushes [m]: the lever
/// with which it turns the world, and how far from the vertex its body is dented. None if no pair pushes.
std::optional<double> longest_lever(const World& world, const Contacts& contacts);

}  // namespace enduring::motivating
