#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

namespace enduring {

/// What makes two contacts the same pair.
using PairKey = std::tuple<ContactKind, int, int, int, int>;

inline PairKey key_of(const Contact& contact)
{
    return {contact.kind, contact.body_a, contact.body_b, contact.feature_a, contact.feature_b};
}

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
