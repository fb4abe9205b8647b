#pragma once

#include "chapters/03_penalty_impulses/crossing_detection.hpp"

namespace enduring {

/// The passes that chapter 6 adds.

/// Enduring: drops what was resolved, redefines or holds vertices, dismisses or holds edges, adds the edge pairs that follow.
void follow_enduring_pairs(const World& world, Contacts& contacts);
/// Detection: new entries, looked through, and handed on where they are hooked. After find_candidates.
void detect_new_pairs(const World& world, const CrossingDetection& detection, Contacts& contacts);
/// Finish: the advanced resolution condition, on the motion that is about to be committed. After find_candidates for it.
void resolve_pairs_that_left(const World& world, const CrossingDetection& detection, Contacts& contacts);

}  // namespace enduring
