#include "chapters/08_contact_by_distance/begins_inside.hpp"

#include "chapters/02_collision_detection/broad_phase.hpp"
#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/own_directions.hpp"
#include "chapters/08_contact_by_distance/skin.hpp"
#include "common/geometry/winding_number.hpp"

#include <algorithm>
#include <array>

namespace enduring {
namespace {

//! [inner_surface]
/// What touches is not inside, but rounding alone decides on which side of each other two surfaces in touch
/// lie. So closed ones are asked for after each has moved in by what rounding may be; those of bodies that
/// keep their shape lie inside by a skin already.
std::vector<Vec3> inner_surface(const Body& body)
{
    const std::span<const Vec3> positions = body.contact_t0();
    if (keeps_shape(body) || !body.surface().is_closed())
        return {positions.begin(), positions.end()};
    return inset_surface(body.surface(), positions, distance_parts.touching * body.size());
}
//! [inner_surface]

/// A surface as it lies when the step begins.
struct Still {
    const SurfaceTopology& topology;
    std::vector<Vec3> positions;
    FaceTree tree;

    explicit Still(const Body& body)
        : topology(body.surface()), positions(inner_surface(body)), tree(topology, positions)
    {
        tree.refit({topology, positions, positions});
    }
    const Vec3& corner(int face, std::size_t i) const
    {
        return positions[static_cast<std::size_t>(topology.faces()[static_cast<std::size_t>(face)][i])];
    }
};

/// Whether a stretch has its ends on both sides of a face, by more than rounding, and goes through it.
bool goes_through(const Vec3& p, const Vec3& q, const Still& b, int face_b)
{
    const std::array<Vec3, 3> f{b.corner(face_b, 0), b.corner(face_b, 1), b.corner(face_b, 2)};
    const Vec3 normal = (f[1] - f[0]).cross(f[2] - f[0]).stableNormalized();
    const double above_p = normal.dot(p - f[0]), above_q = normal.dot(q - f[0]),
                 least = distance_parts.touching * (q - p).norm();
    return std::min(above_p, above_q) < -least && std::max(above_p, above_q) > least &&
           find_edge_triangle_hit(p, q, f[0], f[1], f[2]);
}

/// Whether an edge of one leaf goes through the other, which is a face.
bool any_edge_through(const Still& a, int leaf_a, const Still& b, int face_b)
{
    if (!b.tree.has_faces())
        return false;
    if (a.tree.has_faces())
        return goes_through(a.corner(leaf_a, 0), a.corner(leaf_a, 1), b, face_b) ||
               goes_through(a.corner(leaf_a, 1), a.corner(leaf_a, 2), b, face_b) ||
               goes_through(a.corner(leaf_a, 2), a.corner(leaf_a, 0), b, face_b);
    const std::span<const int> own = a.tree.owned_edges(leaf_a);
    return std::any_of(own.begin(), own.end(), [&](int edge) {
        const auto [p, q] = a.topology.edges()[static_cast<std::size_t>(edge)];
        return goes_through(a.positions[static_cast<std::size_t>(p)],
                            a.positions[static_cast<std::size_t>(q)], b, face_b);
    });
}

bool cross(const Still& a, const Still& b)
{
    bool any = false;
    FaceTree::overlapping_leaves(a.tree, b.tree, [&](int leaf_a, int leaf_b) {
        any = any || any_edge_through(a, leaf_a, b, leaf_b) || any_edge_through(b, leaf_b, a, leaf_a);
    });
    return any;
}

/// For surfaces that do not cross: of a surface one vertex tells, of points and edges each for itself.
bool lies_in(const Still& inner, const Still& outer)
{
    if (!outer.topology.is_closed())
        return false;
    const auto asked = inner.tree.has_faces() ? std::min<std::size_t>(1, inner.positions.size())
                                              : inner.positions.size();
    return std::any_of(inner.positions.begin(), inner.positions.begin() + static_cast<std::ptrdiff_t>(asked),
                       [&](const Vec3& point) {
                           return winding_number(outer.topology.faces(), outer.positions, point) > 0.5;
                       });
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
