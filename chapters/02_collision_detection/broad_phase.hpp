#pragma once

#include "chapters/02_collision_detection/face_tree.hpp"

#include <compare>
#include <vector>

namespace enduring {

/// Three ways to the pairs of features of two surfaces that a query has to look at. Each calls
///     visit.vertex_face(vertex of A, face of B)
///     visit.face_vertex(face of A, vertex of B)
///     visit.edge_edge(edge of A, edge of B)
/// once for each of its pairs, and takes no memory.

/// Every pair there is: a query for each finds every collision, and takes its time.
template <class Visit>
void visit_all_pairs(const SurfaceStep& a, const SurfaceStep& b, Visit&& visit)
{
    const auto faces = [](const SurfaceStep& s) { return static_cast<int>(s.topology.faces().size()); };
    const auto edges = [](const SurfaceStep& s) { return static_cast<int>(s.topology.edges().size()); };
    for (int v = 0; v < a.topology.vertex_count(); ++v)
        for (int f = 0; f < faces(b); ++f)
            visit.vertex_face(v, f);
    for (int f = 0; f < faces(a); ++f)
        for (int v = 0; v < b.topology.vertex_count(); ++v)
            visit.face_vertex(f, v);
    for (int e = 0; e < edges(a); ++e)
        for (int g = 0; g < edges(b); ++g)
            visit.edge_edge(e, g);
}

/// The pairs whose swept boxes overlap, found by looking at every pair of boxes (thesis section 4.4).
/// @param a, b  trees after a refit; only their boxes are used
template <class Visit>
void visit_boxed_pairs(const SurfaceStep& a, const FaceTree& boxes_a, const SurfaceStep& b,
                       const FaceTree& boxes_b, Visit&& visit)
{
    struct Filter {
        const FaceTree &a, &b;
        Visit& visit;
        void vertex_face(int v, int f) const
        {
            if (a.vertex_box(v).overlaps(b.face_box(f)))
                visit.vertex_face(v, f);
        }
        void face_vertex(int f, int v) const
        {
            if (a.face_box(f).overlaps(b.vertex_box(v)))
                visit.face_vertex(f, v);
        }
        void edge_edge(int e, int g) const
        {
            if (a.edge_box(e).overlaps(b.edge_box(g)))
                visit.edge_edge(e, g);
        }
    };
    visit_all_pairs(a, b, Filter{boxes_a, boxes_b, visit});
}

//! [owned_pairs]
/// The pairs of features for which two faces with overlapping boxes speak. Edges without faces speak for
/// themselves and their ends.
template <class Visit>
void visit_owned_pairs(const FaceTree& a, int face_a, const FaceTree& b, int face_b, Visit& visit)
{
    if (b.has_faces())
        for (int v : a.owned_vertices(face_a))
            if (a.vertex_box(v).overlaps(b.face_box(face_b)))
                visit.vertex_face(v, face_b);
    if (a.has_faces())
        for (int v : b.owned_vertices(face_b))
            if (a.face_box(face_a).overlaps(b.vertex_box(v)))
                visit.face_vertex(face_a, v);
    for (int e : a.owned_edges(face_a))
        for (int g : b.owned_edges(face_b))
            if (a.edge_box(e).overlaps(b.edge_box(g)))
                visit.edge_edge(e, g);
}

/// The same pairs, found by descending both trees at once. A feature's box lies in its face's box, so none is
/// lost, and each pair of features has one pair of faces that speaks for it, so none comes twice.
template <class Visit>
void visit_tree_pairs(const FaceTree& a, const FaceTree& b, Visit&& visit)
{
    FaceTree::overlapping_leaves(
        a, b, [&](int face_a, int face_b) { visit_owned_pairs(a, face_a, b, face_b, visit); });
}
//! [owned_pairs]

/// A feature of A and a feature of B.
struct FeaturePair {
    int a, b;
    auto operator<=>(const FeaturePair&) const = default;
};

/// Pairs to look at, kept in lists that keep their memory from step to step.
struct CandidatePairs {
    std::vector<FeaturePair> vertex_face;  ///< vertex of A, face of B
    std::vector<FeaturePair> face_vertex;  ///< face of A, vertex of B
    std::vector<FeaturePair> edge_edge;

    std::size_t size() const { return vertex_face.size() + face_vertex.size() + edge_edge.size(); }
    void clear();
};

/// Fills the lists by the trees' way, in the trees' order: the same input gives the same order.
void collect_pairs(const FaceTree& a, const FaceTree& b, CandidatePairs& pairs);

}  // namespace enduring
