#pragma once

#include "chapters/02_collision_detection/broad_phase.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Chapter 2 as passes: which pairs of features come close in this step, and which of them cross.
///
/// The trees are shaped once, from where the bodies first lie, so a detection belongs to one world. Bodies are
/// tested against each other, never against themselves.
class CrossingDetection {
public:
    /// Boxes of this step, and from them the pairs of features to look at.
    void find_candidates(const World& world);

    /// Appends a contact for every candidate that goes from outside to inside in this step and is not in the list yet.
    /// Call find_candidates for the same prediction before.
    void append_entries(const World& world, Contacts& contacts) const;

    /// Pairs of features that the last find_candidates left for the query.
    std::size_t candidate_count() const;

    /// Calls visit(body_a, vertex, body_b, face) for every vertex and face among them, always in the same order.
    template <class Visit>
    void visit_vertex_face_candidates(Visit&& visit) const
    {
        for (const auto& [a, b, pairs] : body_pairs_) {
            for (const auto& [vertex, face] : pairs.vertex_face)
                visit(a, vertex, b, face);
            for (const auto& [face, vertex] : pairs.face_vertex)
                visit(b, vertex, a, face);
        }
    }

    /// Calls visit(face) for the faces of a body whose boxes of the last find_candidates overlap a box.
    template <class Visit>
    void visit_faces_near(int body, const SweptBox& box, Visit&& visit) const
    {
        trees_[static_cast<std::size_t>(body)].faces_near(box, visit);
    }

private:
    struct BodyPair {
        int a, b;
        CandidatePairs pairs;
    };

    void build(const World& world);

    std::vector<const Body*> bodies_;  ///< whose trees these are
    std::vector<FaceTree> trees_;
    std::vector<BodyPair> body_pairs_;
};

}  // namespace enduring
