#include "chapters/02_collision_detection/broad_phase.hpp"

namespace enduring {
namespace {

struct Collector {
    CandidatePairs& pairs;
    void vertex_face(int v, int f) const { pairs.vertex_face.push_back({v, f}); }
    void face_vertex(int f, int v) const { pairs.face_vertex.push_back({f, v}); }
    void edge_edge(int e, int g) const { pairs.edge_edge.push_back({e, g}); }
};

}  // namespace

void CandidatePairs::clear()
{
    vertex_face.clear();
    face_vertex.clear();
    edge_edge.clear();
}

void collect_pairs(const FaceTree& a, const FaceTree& b, CandidatePairs& pairs)
{
    pairs.clear();
    visit_tree_pairs(a, b, Collector{pairs});
}

}  // namespace enduring
