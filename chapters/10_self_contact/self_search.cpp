#include "chapters/10_self_contact/self_search.hpp"

#include <algorithm>

namespace enduring {
namespace {

//! [own_pairs]
/// Keeps the pairs that are not of neighbours.
struct OwnPairs {
    const RestNeighbours& neighbours;
    CandidatePairs& pairs;

    void vertex_face(int vertex, int face) const
    {
        if (!neighbours.vertex_and_face(vertex, face))
            pairs.vertex_face.push_back({vertex, face});
    }
    void face_vertex(int face, int vertex) const { vertex_face(vertex, face); }
    void edge_edge(int edge, int other) const
    {
        if (!neighbours.edges(edge, other))
            pairs.edge_edge.push_back({std::min(edge, other), std::max(edge, other)});
    }
};

}  // namespace

void collect_own_pairs(const FaceTree& tree, const RestNeighbours& neighbours, CandidatePairs& pairs)
{
    const OwnPairs own{neighbours, pairs};
    FaceTree::overlapping_faces(tree, tree, [&](int face, int other) {
        if (face < other)  // the tree comes to each pair of its faces twice, and to each face with itself
            visit_owned_pairs(tree, face, tree, other, own);
    });
}
//! [own_pairs]

void SelfSearch::find_more(const World& world)
{
    for (int body = 0; body < static_cast<int>(world.bodies.size()); ++body)
        if (const RestNeighbours* neighbours = rest_neighbours(*world.bodies[body]))
            collect_own_pairs(tree(body), *neighbours, append_body_pair(body, body));
}

}  // namespace enduring
