#include "chapters/02_collision_detection/face_tree.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// Faces, or where there are none, edges, and points without an edge.
std::vector<Face> leaves_of(const SurfaceTopology& topology)
{
    std::vector<Face> leaves(topology.faces().begin(), topology.faces().end());
    if (!leaves.empty())
        return leaves;
    for (const auto& [a, b] : topology.edges())
        leaves.push_back({a, b, b});
    for (int v = 0; v < topology.vertex_count(); ++v)
        if (topology.edges_around_vertex(v).empty())
            leaves.push_back({v, v, v});
    return leaves;
}

}  // namespace

FaceTree::FaceTree(const SurfaceTopology& topology, std::span<const Vec3> positions,
                   const std::function<bool(int)>& keeps_vertex, const std::function<bool(int)>& keeps_edge)
    : has_faces_(!topology.faces().empty()), leaves_(leaves_of(topology)), node_of_leaf_(leaves_.size()),
      vertex_boxes_(positions.size()), edge_boxes_(topology.edges().size()), owned_vertices_(leaves_.size()),
      owned_edges_(leaves_.size())
{
    const auto give = [](std::vector<Owned>& owners, int leaf, int feature) {
        Owned& owner = owners[leaf];
        owner.features[owner.count++] = feature;
    };
    const auto edges = static_cast<int>(topology.edges().size());
    int lonely = edges;  // the leaf of the next point without an edge
    for (int v = 0; v < topology.vertex_count(); ++v) {
        const auto around = has_faces_ ? topology.faces_around_vertex(v) : topology.edges_around_vertex(v);
        if (around.empty() && has_faces_)
            continue;  // of no face
        const int owner = around.empty() ? lonely++ : around[0];
        if (keeps_vertex(v))
            give(owned_vertices_, owner, v);
    }
    for (int e = 0; e < edges; ++e)
        if (keeps_edge(e))
            give(owned_edges_, has_faces_ ? topology.faces_at_edge(e)[0] : e, e);

    std::vector<Vec3> middles;
    std::vector<int> leaves;
    for (const auto& [a, b, c] : leaves_) {
        leaves.push_back(static_cast<int>(middles.size()));
        middles.push_back(positions[a] + positions[b] + positions[c]);
    }
    nodes_.reserve(2 * leaves.size());
    if (!leaves.empty())
        build(leaves, middles);
}

/// Halves the leaves by the median of their middles along the direction in which these spread most.
void FaceTree::build(std::span<int> leaves, std::span<const Vec3> middles)
{
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    if (leaves.size() == 1) {
        nodes_[node].second_child = -1 - leaves[0];
        node_of_leaf_[leaves[0]] = static_cast<int>(node);
        return;
    }
    const auto middle = [&](int leaf) -> const Vec3& { return middles[leaf]; };
    SweptBox bounds{middle(leaves[0]), middle(leaves[0])};
    for (int leaf : leaves)
        bounds = bounds | SweptBox{middle(leaf), middle(leaf)};
    Eigen::Index axis = 0;
    (bounds.high - bounds.low).maxCoeff(&axis);

    const std::size_t half = leaves.size() / 2;
    std::nth_element(
        leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(half), leaves.end(), [&](int f, int g) {
            return middle(f)[axis] != middle(g)[axis] ? middle(f)[axis] < middle(g)[axis] : f < g;
        });
    build(leaves.first(half), middles);
    nodes_[node].second_child = static_cast<int>(nodes_.size());
    build(leaves.subspan(half), middles);
}

//! [refit]
void FaceTree::refit(const SurfaceStep& surface, double margin)
{
    for (std::size_t v = 0; v < vertex_boxes_.size(); ++v)
        vertex_boxes_[v] = enduring::vertex_box(surface, static_cast<int>(v)).grown_by(margin);
    for (std::size_t e = 0; e < edge_boxes_.size(); ++e) {
        const auto [a, b] = surface.topology.edges()[e];
        edge_boxes_[e] = vertex_box(a) | vertex_box(b);
    }
    for (std::size_t n = nodes_.size(); n-- > 0;) {  // children stand behind their parents
        Node& node = nodes_[n];
        if (node.is_leaf()) {
            const auto [a, b, c] = leaves_[static_cast<std::size_t>(node.leaf())];
            node.box = vertex_box(a) | vertex_box(b) | vertex_box(c);
        } else {
            node.box = nodes_[n + 1].box | nodes_[node.second_child].box;
        }
    }
}
//! [refit]

}  // namespace enduring
