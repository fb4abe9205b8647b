#include "chapters/02_collision_detection/broad_phase.hpp"
#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/skin.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace enduring {
namespace {

Vec3 normal_of(const Face& face, std::span<const Vec3> x)
{
    const auto at = [&](int corner) {
        return x[static_cast<std::size_t>(face[static_cast<std::size_t>(corner)])];
    };
    return (at(1) - at(0)).cross(at(2) - at(0));
}

/// How a vertex moves so that its planes move inwards by 1: least squares over the different ones, and not
/// along directions about which they say little.
Vec3 recess(const SurfaceTopology& surface, std::span<const Vec3> x, int vertex)
{
    Mat3 planes = Mat3::Zero();
    Vec3 inwards = Vec3::Zero();
    std::vector<Vec3> seen;
    for (const int f : surface.faces_around_vertex(vertex)) {
        const Vec3 normal = normal_of(surface.faces()[static_cast<std::size_t>(f)], x).stableNormalized();
        const bool again = std::any_of(seen.begin(), seen.end(), [&](const Vec3& other) {
            return (other - normal).norm() < distance_parts.least_fold;
        });
        if (normal.isZero(0) || again)
            continue;
        seen.push_back(normal);
        planes += normal * normal.transpose();
        inwards -= normal;
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> own(planes);
    const double least = distance_parts.least_recess * distance_parts.least_recess * own.eigenvalues()[2];
    Vec3 move = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
        if (own.eigenvalues()[i] > least)
            move += own.eigenvectors().col(i) *
                    (own.eigenvectors().col(i).dot(inwards) / own.eigenvalues()[i]);
    return move;
}

/// Faces of which less than a part of the normal would be left.
void mark_turned(const SurfaceTopology& surface, std::span<const Vec3> from, std::span<const Vec3> to,
                 std::vector<bool>& marked)
{
    for (const Face& face : surface.faces()) {
        const Vec3 before = normal_of(face, from);
        if (before.dot(normal_of(face, to)) < distance_parts.not_turned * before.squaredNorm())
            for (const int v : face)
                marked[static_cast<std::size_t>(v)] = true;
    }
}

/// Marks the vertices of features that would meet on the way in: the way is a step, and chapter 2's query is
/// asked. Features with a common vertex are left out.
class Meetings {
public:
    Meetings(const SurfaceStep& step, std::vector<bool>& marked) : step_(step), marked_(marked) {}

    void vertex_face(int v, int f) const
    {
        const Face& face = step_.face(f);
        if (std::find(face.begin(), face.end(), v) == face.end() &&
            time_of_impact(vertex_face_step(step_, v, step_, f)))
            mark({v, face[0], face[1], face[2]});
    }
    void face_vertex(int f, int v) const { vertex_face(v, f); }
    void edge_edge(int e, int g) const
    {
        const Edge &a = step_.edge(e), &b = step_.edge(g);
        const bool common = a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
        if (!common && time_of_impact(edge_edge_step(step_, e, step_, g)))
            mark({a[0], a[1], b[0], b[1]});
    }

private:
    void mark(const std::array<int, 4>& vertices) const
    {
        for (const int v : vertices)
            marked_[static_cast<std::size_t>(v)] = true;
    }

    const SurfaceStep& step_;
    std::vector<bool>& marked_;
};

void mark_meetings(const SurfaceTopology& surface, std::span<const Vec3> from, std::span<const Vec3> to,
                   std::vector<bool>& marked)
{
    const SurfaceStep step{surface, from, to};
    FaceTree tree(surface, from);
    tree.refit(step, 0);
    const Meetings meetings(step, marked);
    FaceTree::overlapping_faces(tree, tree, [&](int face, int other) {
        if (face < other)
            visit_owned_pairs(tree, face, tree, other, meetings);
    });
}

}  // namespace

//! [inset]
std::vector<Vec3> inset_surface(const SurfaceTopology& surface, std::span<const Vec3> positions,
                                double distance)
{
    const std::size_t count = positions.size();
    std::vector<Vec3> way(count), moved(count);
    for (std::size_t v = 0; v < count; ++v)
        way[v] = distance * recess(surface, positions, static_cast<int>(v));
    std::vector<double> part(count, 1);
    for (int tries = 0; tries < 20; ++tries) {
        for (std::size_t v = 0; v < count; ++v)
            moved[v] = positions[v] + part[v] * way[v];
        std::vector<bool> too_far(count, false);
        mark_turned(surface, positions, moved, too_far);
        mark_meetings(surface, positions, moved, too_far);
        if (std::none_of(too_far.begin(), too_far.end(), [](bool any) { return any; }))
            return moved;
        for (std::size_t v = 0; v < count; ++v)
            if (too_far[v])
                part[v] = tries < 12 ? 0.5 * part[v] : 0;
    }
    return {positions.begin(), positions.end()};  // it meets itself where it lies
}
//! [inset]

}  // namespace enduring
