#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

// A vertex-face pair is hooked falsely if chapter 5 calls it hooked, and
//   it pushes its vertex against the cone of its normals, give or take 45 degrees. For an edge the span and the
//     cone agree: a pair pushes it at right angles to itself, as its normals stand, and there no direction of the
//     cone is farther than 45 degrees from a normal or their average; or
//   the face to which chapter 6 would hand it lies deeper above its vertex than it can have come.

/// Before new pairs are admitted: those that are hooked falsely are regular.
void admit_falsely_hooked(const World& world, Contacts& contacts);

/// Takes the vertex-face pairs that are hooked falsely off the list, before chapter 6 follows the others. It
/// would hand them on or hold them.
Contacts take_falsely_hooked(const World& world, Contacts& contacts);

/// Follows those pairs as chapter 6 follows regular ones: each acts at its foot. Where the foot has left its
/// face, here and where chapter 6 has found no other face, the best one counts that the cone calls regular.
/// @param contacts  the list without them; gets them back
void follow_by_cone(const World& world, const Contacts& falsely, Contacts& contacts);

}  // namespace enduring
