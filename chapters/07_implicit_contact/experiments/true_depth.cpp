#include "chapters/07_implicit_contact/experiments/true_depth.hpp"

#include "common/geometry/triangle_distance.hpp"
#include "common/geometry/winding_number.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace enduring::chapter07 {
namespace {

using Aabb = Eigen::AlignedBox3d;

Aabb box_of(std::span<const Vec3> points)
{
    Aabb box;
    for (const Vec3& point : points)
        box.extend(point);
    return box;
}

/// Whether a point lies over or under a triangle.
bool lies_over(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a);
    return normal.dot((b - a).cross(point - a)) >= 0 && normal.dot((c - b).cross(point - b)) >= 0 &&
           normal.dot((a - c).cross(point - c)) >= 0;
}

/// Where bodies are, with what spares most questions about points.
struct Solid {
    explicit Solid(const Body& body)
        : faces(body.surface().faces()), positions(body.positions_t0()), closed(body.surface().is_closed()),
          box(box_of(positions)), middle(box.center())
    {
        for (const Vec3& point : positions)
            radius = std::max(radius, (point - middle).norm());
    }
    const Vec3& corner(int vertex) const { return positions[static_cast<std::size_t>(vertex)]; }
    /// Of a point inside; 0 for others [m].
    double depth(const Vec3& point) const
    {
        if (!closed || !box.contains(point) || (point - middle).norm() > radius ||
            winding_number(faces, positions, point) < 0.5)
            return 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : faces)
            nearest = std::min(nearest, distance_to_triangle(point, corner(a), corner(b), corner(c)));
        return nearest;
    }

    /// Whether a point lies over or under one of the faces.
    bool faces_across(const Vec3& point) const
    {
        return std::any_of(faces.begin(), faces.end(), [&](const Face& face) {
            return lies_over(point, corner(face[0]), corner(face[1]), corner(face[2]));
        });
    }

    std::span<const Face> faces;
    std::span<const Vec3> positions;
    bool closed;
    Aabb box;
    Vec3 middle;
    double radius = 0;
};

/// Where a segment passes a triangle: its parameter, and how far behind the triangle's plane its ends lie.
struct Passage {
    double at;
    double from_behind, to_behind;  ///< [m]
};

std::optional<Passage> passage(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();
    const double from = normal.dot(a - p), to = normal.dot(a - q);
    if ((from > 0) == (to > 0))
        return std::nullopt;
    const double at = from / (from - to);
    if (!lies_over(lerp(p, q, at), a, b, c))
        return std::nullopt;
    return Passage{at, from, to};
}

/// Of an edge that passes an open surface: how far it lies behind the face at its end or, if it goes on
/// beyond the border, there [m]; of its two parts, that with less.
double sheet_depth(const Vec3& p, const Vec3& q, const Passage& passed, const Solid& sheet)
{
    const auto depth_towards = [&](double end, double at_end) {
        double over = passed.at, beyond = end;
        if (sheet.faces_across(lerp(p, q, end)))
            return std::abs(at_end);
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (over + beyond);
            (sheet.faces_across(lerp(p, q, middle)) ? over : beyond) = middle;
        }
        return std::abs(at_end * (over - passed.at) / (end - passed.at));
    };
    return std::min(depth_towards(0, passed.from_behind), depth_towards(1, passed.to_behind));
}

/// Of what an edge has inside a surface.
double edge_depth(const Vec3& p, const Vec3& q, const Solid& solid)
{
    double deepest = 0;
    std::vector<double> places;
    for (const auto& [a, b, c] : solid.faces)
        if (const auto passed = passage(p, q, solid.corner(a), solid.corner(b), solid.corner(c))) {
            places.push_back(passed->at);
            if (!solid.closed)
                deepest = std::max(deepest, sheet_depth(p, q, *passed, solid));
        }
    if (places.empty() || !solid.closed)
        return deepest;
    places.insert(places.end(), {0, 1});
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        deepest = std::max(deepest, solid.depth(lerp(p, q, 0.5 * (places[i] + places[i + 1]))));
    return deepest;
}

double depth_in(const Body& a, const Solid& solid)
{
    const auto at = a.positions_t0();
    double deepest = 0;
    for (const Vec3& vertex : at)
        deepest = std::max(deepest, solid.depth(vertex));
    for (const auto& [from, to] : a.surface().edges()) {
        const Vec3 &p = at[static_cast<std::size_t>(from)], &q = at[static_cast<std::size_t>(to)];
        Aabb box(p);
        if (box.extend(q).intersects(solid.box))
            deepest = std::max(deepest, edge_depth(p, q, solid));
    }
    return deepest;
}

}  // namespace

double true_depth(const Body& a, const Body& b) { return depth_in(a, Solid(b)); }

double true_depth(const World& world)
{
    std::vector<Solid> solids;
    for (const auto& body : world.bodies)
        solids.emplace_back(*body);
    double deepest = 0;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const Body& body = *world.bodies[i];
        for (std::size_t j = 0; j < solids.size(); ++j)
            if (i != j && !(body.is_static() && world.bodies[j]->is_static()) &&
                solids[i].box.intersects(solids[j].box))
                deepest = std::max(deepest, depth_in(body, solids[j]));
        for (const Plane& plane : world.planes)
            for (const Vec3& vertex : body.positions_t0())
                if (!body.is_static())
                    deepest = std::max(deepest, plane.normal.dot(plane.point - vertex));
    }
    return deepest;
}

}  // namespace enduring::chapter07
