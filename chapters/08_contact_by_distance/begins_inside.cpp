#include "chapters/08_contact_by_distance/begins_inside.hpp"

#include "chapters/02_collision_detection/broad_phase.hpp"
#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "common/geometry/winding_number.hpp"

#include <algorithm>
#include <array>

namespace enduring {
namespace {

/// A surface as it lies when the step begins.
struct Still {
    const SurfaceTopology& topology;
    std::span<const Vec3> positions;
    FaceTree tree;

    explicit Still(const Body& body)
        : topology(body.surface()), positions(body.contact_t0()), tree(topology, positions)
    {
        tree.refit({topology, positions, positions});
    }
    const Vec3& corner(int face, std::size_t i) const
    {
        return positions[static_cast<std::size_t>(topology.faces()[static_cast<std::size_t>(face)][i % 3])];
    }
};

/// Whether an edge of one face has its ends on both sides of the other face, by more than rounding, and goes through it.
bool any_edge_through(const Still& a, int face_a, const Still& b, int face_b)
{
    const std::array<Vec3, 3> f{b.corner(face_b, 0), b.corner(face_b, 1), b.corner(face_b, 2)};
    const Vec3 normal = (f[1] - f[0]).cross(f[2] - f[0]).stableNormalized();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &p = a.corner(face_a, i), &q = a.corner(face_a, i + 1);
        const double above_p = normal.dot(p - f[0]), above_q = normal.dot(q - f[0]),
                     least = distance_parts.touching * (q - p).norm();
        if (std::min(above_p, above_q) < -least && std::max(above_p, above_q) > least &&
            find_edge_triangle_hit(p, q, f[0], f[1], f[2]))
            return true;
    }
    return false;
}

bool cross(const Still& a, const Still& b)
{
    bool any = false;
    FaceTree::overlapping_faces(a.tree, b.tree, [&](int face_a, int face_b) {
        any = any || any_edge_through(a, face_a, b, face_b) || any_edge_through(b, face_b, a, face_a);
    });
    return any;
}

/// For surfaces that do not cross.
bool lies_in(const Still& inner, const Still& outer)
{
    return outer.topology.is_closed() && !inner.positions.empty() &&
           winding_number(outer.topology.faces(), outer.positions, inner.positions.front()) > 0.5;
}

}  // namespace

std::vector<TwoBodies> bodies_inside_each_other(const World& world)
{
    std::vector<Still> surfaces;
    surfaces.reserve(world.bodies.size());
    for (const auto& body : world.bodies)
        surfaces.emplace_back(*body);
    std::vector<TwoBodies> found;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (std::size_t j = i + 1; j < surfaces.size(); ++j) {
            const Still &a = surfaces[i], &b = surfaces[j];
            if (!a.tree.box().overlaps(b.tree.box()) ||
                !bodies_may_meet(world, static_cast<int>(i), static_cast<int>(j)))
                continue;
            if (cross(a, b) || lies_in(a, b) || lies_in(b, a))
                found.emplace_back(static_cast<int>(i), static_cast<int>(j));
        }
    return found;
}

}  // namespace enduring
