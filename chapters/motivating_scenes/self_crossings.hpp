#pragma once

#include "common/simulation/body.hpp"

#include <span>

namespace enduring::motivating {

/// How many edges of a body pass through its own faces, at the committed state. It looks at all pairs, and
/// knows nothing of any chapter's contacts.
/// @param first  where the vertices were when the body did not touch itself [m]
/// @param apart  only edges and faces whose middles were farther from each other count [m]
/// @param skin   is taken off the surface before; what is pressed in by less does not cross [m]
int self_crossings(const Body& body, std::span<const Vec3> first, double apart, double skin);

}  // namespace enduring::motivating
