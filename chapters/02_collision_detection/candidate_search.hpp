#pragma once

#include "chapters/02_collision_detection/broad_phase.hpp"
#include "common/simulation/step.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

namespace enduring {

/// The broad phase over a world: which pairs of features come close in this step.
///
/// The trees are shaped once, from where the bodies first lie, so a search belongs to one world. Bodies are
/// tested against each other, never against themselves, nor against what a joint holds them to.
class CandidateSearch {
public:
    virtual ~CandidateSearch() = default;
    /// Boxes of this step, and from them the pairs of features to look at.
    /// @param margins  of each body: by how much the box of each of its features is larger on each side [m];
    ///     none: 0
    void find_candidates(const World& world, std::span<const double> margins = {});
    /// The same after some bodies have another prediction: boxes of all others stand, and so do pairs of
    /// features of two others.
    /// @param moved  for each body, whether it has
    void refit_candidates(const World& world, std::span<const double> margins,
                          const std::vector<bool>& moved);

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

protected:
    /// Whether a vertex may ever meet a face, and an edge another one; asked once, when the trees are shaped.
    virtual bool vertex_may_meet(const Body& /*body*/, int /*vertex*/) const { return true; }
    virtual bool edge_may_meet(const Body& /*body*/, int /*edge*/) const { return true; }
    /// For a search that finds more; at the end of find_candidates, with its boxes.
    virtual void find_more(const World& /*world*/) {}
    const FaceTree& tree(int body) const { return trees_[body]; }
    /// Pairs of features of two bodies, empty at first, which are visited behind all others.
    CandidatePairs& append_body_pair(int a, int b)
    {
        return body_pairs_.emplace_back(BodyPair{a, b, {}}).pairs;
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
    std::vector<BodyPair> last_pairs_;  ///< those before the last refit
};

/// What makes two contacts the same pair.
using PairKey = std::tuple<ContactKind, int, int, int, int>;

inline PairKey key_of(const Contact& contact)
{
    return {contact.kind, contact.body_a, contact.body_b, contact.feature_a, contact.feature_b};
}

/// Ascending by their keys.
void sort_by_keys(Contacts& contacts);

/// Whether two bodies are to be looked at: at least one can move, and no joint holds them together.
bool bodies_may_meet(const World& world, int body_a, int body_b);

/// The pairs that are in the list already, for look-up in logarithmic time.
class KnownPairs {
public:
    explicit KnownPairs(const Contacts& contacts)
    {
        keys_.reserve(contacts.size());
        for (const Contact& contact : contacts)
            keys_.push_back(key_of(contact));
        std::sort(keys_.begin(), keys_.end());
    }
    bool contain(const Contact& contact) const
    {
        return std::binary_search(keys_.begin(), keys_.end(), key_of(contact));
    }

private:
    std::vector<PairKey> keys_;
};

//! [append_pairs]
/// Asks a query about every candidate that is not in the list yet, and appends those of which it says where
/// and when they meet: an optional of what has `time`, `weights` and `orientation` as Contact has them.
/// @param search       after find_candidates for the present prediction
/// @param vertex_face  query of a VertexFaceStep
/// @param edge_edge    query of an EdgeEdgeStep, of the two surfaces and of the edges on them
template <class VertexFaceQuery, class EdgeEdgeQuery>
void append_pairs(const World& world, const CandidateSearch& search, const VertexFaceQuery& vertex_face,
                  const EdgeEdgeQuery& edge_edge, Contacts& contacts)
{
    const KnownPairs known(contacts);
    const auto surface = [&](int body) { return surface_step(*world.bodies[body]); };
    const auto append = [&](Contact& contact, const auto& meeting) {
        if (!meeting)
            return;
        contact.weights = meeting->weights;
        contact.orientation = contact.kind == ContactKind::edge_edge ? meeting->orientation : 1;
        contact.start = meeting->time;
        contacts.push_back(contact);
    };
    search.visit_candidates(
        [&](int body_a, int vertex, int body_b, int face) {
            Contact contact{ContactKind::vertex_face, body_a, body_b, vertex, face};
            if (known.contain(contact))
                return;
            const SurfaceStep a = surface(body_a), b = surface(body_b);
            const auto [f0, f1, f2] = b.face(face);
            contact.vertices = {vertex, f0, f1, f2};
            append(contact, vertex_face(vertex_face_step(a, vertex, b, face)));
        },
        [&](int body_a, int edge_a, int body_b, int edge_b) {
            Contact contact{ContactKind::edge_edge, body_a, body_b, edge_a, edge_b};
            if (known.contain(contact))
                return;
            const SurfaceStep a = surface(body_a), b = surface(body_b);
            const auto [a0, a1] = a.edge(edge_a);
            const auto [b0, b1] = b.edge(edge_b);
            contact.vertices = {a0, a1, b0, b1};
            append(contact, edge_edge(edge_edge_step(a, edge_a, b, edge_b), a, edge_a, b, edge_b));
        });
}
//! [append_pairs]

}  // namespace enduring
