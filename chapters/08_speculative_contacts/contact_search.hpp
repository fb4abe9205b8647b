#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/08_speculative_contacts/meeting.hpp"

namespace enduring {

/// Which features of a world may push each other in a step: where the distance of two surfaces is least in their
/// neighbourhood, before they touch. It follows from where the surfaces are and how they move, and from which pairs
/// are known; not from how they came there.
///
/// The trees are shaped once, so a search belongs to one world. Nothing else that it keeps lasts beyond a step.
class ContactSearch : public CandidateSearch {
public:
    /// @param known  pairs of the last step, which may pass the ends of their features by a hair
    /// @param dt     length of the step [s]
    /// @return       waiting pairs, ascending by their keys, without stiffness or load
    Contacts find(const World& world, const Contacts& known, double dt);

    /// Whether some vertex ends elsewhere than when find() looked, so that new features may face each other: by more than the
    /// margin along gravity (a body that is held ends by g dt^2 higher), or by more than a part of it across gravity.
    bool has_moved(const World& world) const;

protected:
    bool vertex_may_meet(const Body& body, int vertex) const override;
    bool edge_may_meet(const Body& body, int edge) const override;

private:
    double margin_ = 0;
    std::vector<std::vector<Vec3>> seen_t1_;  ///< by the last find()
};

/// From how far pairs are made [m].
double search_margin(const World& world, double dt);

/// The planes' pairs: vertices that are near a plane or below it at the start of the step, or below it at the end.
void append_plane_pairs(const World& world, double margin, Contacts& contacts);

}  // namespace enduring
