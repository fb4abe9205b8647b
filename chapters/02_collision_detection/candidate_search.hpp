#pragma once

#include "chapters/02_collision_detection/broad_phase.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// The broad phase over a world: which pairs of features come close in this step.
///
/// The trees are shaped once, from where the bodies first lie, so a search belongs to one world. Bodies are
/// tested against each other, never against themselves.
class CandidateSearch {
public:
    /// Boxes of this step, and from them the pairs of features to look at.
    void find_candidates(const World& world);

    /// Pairs of bodies whose boxes overlap, and of which at least one can
    /// move: those whose features are looked at.
    std::size_t body_pair_count() const { return body_pairs_.size(); }
    /// Pairs of features that the last find_candidates left for the query.
    std::size_t candidate_count() const;

    /// Calls vertex_face(body_a, vertex, body_b, face) and edge_edge(body_a, edge_a, body_b, edge_b) for each
    /// of them, always in the same order.
    template <class VertexFace, class EdgeEdge>
    void visit_candidates(VertexFace&& vertex_face, EdgeEdge&& edge_edge) const
    {
        for (const auto& [a, b, pairs] : body_pairs_) {
            for (const auto& [vertex, face] : pairs.vertex_face)
                vertex_face(a, vertex, b, face);
            for (const auto& [face, vertex] : pairs.face_vertex)
                vertex_face(b, vertex, a, face);
            for (const auto& [edge_a, edge_b] : pairs.edge_edge)
                edge_edge(a, edge_a, b, edge_b);
        }
    }

    /// Calls visit(face) for the faces of a body whose boxes of the last find_candidates overlap a box.
    template <class Visit>
    void visit_faces_near(int body, const SweptBox& box, Visit&& visit) const
    {
        trees_[body].faces_near(box, visit);
    }

private:
    struct BodyPair {
        int a, b;
        CandidatePairs pairs;
    };

    void build(const World& world);

    std::vector<const Body*> bodies_;  ///< whose trees these are
    std::vector<FaceTree> trees_;
    std::vector<BodyPair> body_pairs_;  ///< of this step, ascending
};

}  // namespace enduring
