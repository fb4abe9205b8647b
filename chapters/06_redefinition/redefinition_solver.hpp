#pragma once

#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "common/simulation/scene.hpp"

namespace enduring {

/// The course's last solver: friction as in chapter 4, categories as in chapter 5, and pairs of features that follow the
/// motion (thesis 6). A vertex that is inside a body has exactly one pair with it; what pushes is regular, acts where
/// the features are now, and ends when they part. It keeps the trees of one world, so make one for each run.
Solver chapter06_solver(const ContactParameters& parameters);

/// The passes it adds, for tests and for experiments that measure them one by one.

/// Enduring: drops what was resolved, redefines or holds vertices, dismisses or holds edges, adds the edge pairs that follow.
void follow_enduring_pairs(const World& world, Contacts& contacts);
/// Detection: new entries, looked through, and handed on where they are hooked. After find_candidates.
void detect_new_pairs(const World& world, const CrossingDetection& detection, Contacts& contacts);
/// Finish: the advanced resolution condition, on the motion that is about to be committed. After find_candidates for it.
void resolve_pairs_that_left(const World& world, const CrossingDetection& detection, Contacts& contacts);

}  // namespace enduring
