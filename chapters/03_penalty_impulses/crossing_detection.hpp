#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// The mean outward direction of the faces at an edge, at the start of the step.
Vec3 outward_at_edge(const SurfaceStep& surface, int edge);

/// Chapter 2's search, and which of its candidates cross inwards.
class CrossingDetection : public CandidateSearch {
public:
    /// Appends a contact for every candidate that goes from outside to inside in this step and is not in the
    /// list yet. Call find_candidates for the same prediction before.
    void append_entries(const World& world, Contacts& contacts) const;
};

/// Resolution: removes the pairs of features whose depth is positive at the start of the step (thesis 5.2.1).
void resolve_separated_pairs(const World& world, Contacts& contacts);

}  // namespace enduring
