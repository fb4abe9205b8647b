#pragma once

#include "chapters/02_collision_detection/swept_box.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace enduring {

/// A binary tree of boxes over the faces of one surface. Its shape is made once, from
/// where the faces lie at first; each step only refits the boxes. That stays good as
/// long as neighbours stay neighbours, which a body's do.
///
/// Every vertex and every edge is owned by the first of its faces. A pair of faces then speaks for the
/// features that the two own, and each pair of features has one pair of faces that speaks for it.
///
/// Where there are no faces, the edges stand in their place, and points without an edge: each is a leaf, and
/// no leaf is a face.
class FaceTree {
public:
    FaceTree() = default;
    /// Builds the shape; call refit before the first search.
    /// @param positions     of the vertices at any one time [m]
    /// @param keeps_vertex  of all vertices, those that are looked for
    /// @param keeps_edge    of all edges
    FaceTree(const SurfaceTopology& topology, std::span<const Vec3> positions,
             const std::function<bool(int)>& keeps_vertex = keeps_all,
             const std::function<bool(int)>& keeps_edge = keeps_all);
    static bool keeps_all(int /*feature*/) { return true; }

    /// Boxes around this step, from the leaves to the root. No memory is taken.
    /// @param margin  by which all boxes are larger on each side [m]
    void refit(const SurfaceStep& surface, double margin = 0);

    /// Calls visit(leaf of a, leaf of b) for all pairs of leaves whose
    /// boxes overlap, always in the same order. A face has the number of its leaf.
    template <class Visit>
    static void overlapping_leaves(const FaceTree& a, const FaceTree& b, Visit&& visit)
    {
        if (!a.nodes_.empty() && !b.nodes_.empty())
            descend(a, 0, b, 0, visit);
    }
    /// The same for faces alone.
    template <class Visit>
    static void overlapping_faces(const FaceTree& a, const FaceTree& b, Visit&& visit)
    {
        if (a.has_faces_ && b.has_faces_)
            overlapping_leaves(a, b, visit);
    }
    /// Whether its leaves are faces.
    bool has_faces() const { return has_faces_; }

    /// Calls visit(face) for all faces whose boxes overlap one box, always in the same order.
    template <class Visit>
    void faces_near(const SweptBox& box, Visit&& visit) const
    {
        if (has_faces_)
            descend(0, box, visit);
    }

    /// Calls visit(face) for the faces whose boxes are nearer to a point than the square root of `bound`, the
    /// nearer half of the tree first. A visit may lower the bound: a search for the nearest face.
    /// @param bound  squared distance [m^2]
    template <class Visit>
    void visit_near(const Vec3& point, const double& bound, Visit&& visit) const
    {
        if (has_faces_ && squared_distance(nodes_[0].box, point) < bound)
            approach(0, point, bound, visit);
    }

    /// Around the whole surface; for one without leaves a box that overlaps nothing.
    SweptBox box() const { return nodes_.empty() ? SweptBox::empty() : nodes_[0].box; }
    const SweptBox& vertex_box(int vertex) const { return vertex_boxes_[vertex]; }
    const SweptBox& edge_box(int edge) const { return edge_boxes_[edge]; }
    /// Of a face, or of another leaf.
    const SweptBox& face_box(int face) const
    {
        return nodes_[node_of_leaf_[static_cast<std::size_t>(face)]].box;
    }
    std::span<const int> owned_vertices(int face) const { return owned(owned_vertices_, face); }
    std::span<const int> owned_edges(int face) const { return owned(owned_edges_, face); }

private:
    /// The first child of an inner node stands right behind it; for a leaf, second_child is -1 - its number.
    struct Node {
        SweptBox box;
        int second_child = 0;
        bool is_leaf() const { return second_child < 0; }
        int leaf() const { return -1 - second_child; }
        double extent() const { return (box.high - box.low).sum(); }
    };
    /// At most three vertices, or edges, of one leaf.
    struct Owned {
        std::array<int, 3> features{};
        int count = 0;
    };

    void build(std::span<int> leaves, std::span<const Vec3> middles);
    static double squared_distance(const SweptBox& box, const Vec3& point)
    {
        return (box.low - point).cwiseMax(point - box.high).cwiseMax(0).squaredNorm();
    }

    template <class Visit>
    void approach(int i, const Vec3& point, const double& bound, Visit& visit) const
    {
        const Node& node = nodes_[i];
        if (node.is_leaf())
            return visit(node.leaf());
        int near = i + 1, far = node.second_child;
        double to_near = squared_distance(nodes_[near].box, point);
        double to_far = squared_distance(nodes_[far].box, point);
        if (to_far < to_near) {
            std::swap(near, far);
            std::swap(to_near, to_far);
        }
        if (to_near < bound)
            approach(near, point, bound, visit);
        if (to_far < bound)
            approach(far, point, bound, visit);
    }

    static std::span<const int> owned(const std::vector<Owned>& all, int face)
    {
        const Owned& one = all[face];
        return {one.features.data(), static_cast<std::size_t>(one.count)};
    }

    template <class Visit>
    void descend(int i, const SweptBox& box, Visit& visit) const
    {
        const Node& node = nodes_[i];
        if (!node.box.overlaps(box))
            return;
        if (node.is_leaf())
            return visit(node.leaf());
        descend(i + 1, box, visit);
        descend(node.second_child, box, visit);
    }

    //! [descend]
    template <class Visit>
    static void descend(const FaceTree& a, int i, const FaceTree& b, int j, Visit& visit)
    {
        const Node &in_a = a.nodes_[i], &in_b = b.nodes_[j];
        if (!in_a.box.overlaps(in_b.box))
            return;
        if (in_a.is_leaf() && in_b.is_leaf()) {
            visit(in_a.leaf(), in_b.leaf());
        } else if (in_b.is_leaf() || (!in_a.is_leaf() && in_a.extent() > in_b.extent())) {
            descend(a, i + 1, b, j, visit);
            descend(a, in_a.second_child, b, j, visit);
        } else {
            descend(a, i, b, j + 1, visit);
            descend(a, i, b, in_b.second_child, visit);
        }
    }
    //! [descend]

    std::vector<Node> nodes_;
    bool has_faces_ = false;
    std::vector<Face> leaves_;  ///< their vertices; those of an edge or a point stand there more than once
    std::vector<int> node_of_leaf_;
    std::vector<SweptBox> vertex_boxes_, edge_boxes_;
    std::vector<Owned> owned_vertices_, owned_edges_;
};

}  // namespace enduring
