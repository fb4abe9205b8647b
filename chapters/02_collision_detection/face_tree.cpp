#include "chapters/02_collision_detection/face_tree.hpp"

#include <algorithm>

namespace enduring {

FaceTree::FaceTree(const SurfaceTopology& topology, std::span<const Vec3> positions,
                   const std::function<bool(int)>& keeps_vertex, const std::function<bool(int)>& keeps_edge)
    : leaf_of_face_(topology.faces().size()), vertex_boxes_(positions.size()),
      edge_boxes_(topology.edges().size()), owned_vertices_(topology.faces().size()),
      owned_edges_(topology.faces().size())
{
    const auto give = [](std::vector<Owned>& owners, int face, int feature) {
        Owned& owner = owners[face];
        owner.features[owner.count++] = feature;
    };
    for (int v = 0; v < topology.vertex_count(); ++v)
        if (const auto faces = topology.faces_around_vertex(v); !faces.empty() && keeps_vertex(v))
            give(owned_vertices_, faces[0], v);
    for (int e = 0; e < static_cast<int>(topology.edges().size()); ++e)
        if (keeps_edge(e))
            give(owned_edges_, topology.faces_at_edge(e)[0], e);

    std::vector<Vec3> middles;
    std::vector<int> faces;
    for (const auto& [a, b, c] : topology.faces()) {
        faces.push_back(static_cast<int>(middles.size()));
        middles.push_back(positions[a] + positions[b] + positions[c]);
    }
    nodes_.reserve(2 * faces.size());
    if (!faces.empty())
        build(faces, middles);
}

/// Halves the faces by the median of their middles along the direction in which these spread most.
void FaceTree::build(std::span<int> faces, std::span<const Vec3> middles)
{
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    if (faces.size() == 1) {
        nodes_[node].second_child = -1 - faces[0];
        leaf_of_face_[faces[0]] = static_cast<int>(node);
        return;
    }
    const auto middle = [&](int face) -> const Vec3& { return middles[face]; };
    SweptBox bounds{middle(faces[0]), middle(faces[0])};
    for (int face : faces)
        bounds = bounds | SweptBox{middle(face), middle(face)};
    Eigen::Index axis = 0;
    (bounds.high - bounds.low).maxCoeff(&axis);

    const std::size_t half = faces.size() / 2;
    std::nth_element(
        faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(half), faces.end(), [&](int f, int g) {
            return middle(f)[axis] != middle(g)[axis] ? middle(f)[axis] < middle(g)[axis] : f < g;
        });
    build(faces.first(half), middles);
    nodes_[node].second_child = static_cast<int>(nodes_.size());
    build(faces.subspan(half), middles);
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
            const auto [a, b, c] = surface.face(node.face());
            node.box = vertex_box(a) | vertex_box(b) | vertex_box(c);
        } else {
            node.box = nodes_[n + 1].box | nodes_[node.second_child].box;
        }
    }
}
//! [refit]

}  // namespace enduring
