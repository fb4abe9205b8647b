#include "chapters/09_deep_contacts/inside_pairs.hpp"

#include "chapters/02_collision_detection/body_broad_phase.hpp"
#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/06_redefinition/contact_index.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "common/geometry/closest_points.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

//! [append]
/// A pair for each of the vertices that has none with the other body.
void append_pairs_of(int body_a, const StillSurface& inner, const std::vector<int>& vertices, int body_b,
                     const StillSurface& other, const Vec3& direction, const VertexContacts& in_contact,
                     Contacts& contacts)
{
    for (const int vertex : vertices) {
        if (in_contact.find(body_a, vertex, body_b) >= 0)
            continue;
        const Exit exit = find_exit(other, inner.positions[vertex], direction);
        if (exit.face < 0)
            continue;
        Contact pair{ContactKind::vertex_face, body_a, body_b, vertex, exit.face};
        pair.vertices[0] = vertex;
        pair.weights[0] = 1;
        pair.category = ContactCategory::regular;
        put_on_face(pair, other.topology, exit.face, exit.weights);
        contacts.push_back(pair);
    }
}
//! [append]

using Curve = std::vector<Vec3>;  ///< the points of its piercings, in their order

std::vector<Curve> curves_around(const Overlap& overlap, const StillSurface& a, const StillSurface& b)
{
    std::vector<Curve> curves;
    for (const std::vector<Piercing>& piercings : overlap.curves) {
        Curve& curve = curves.emplace_back();
        for (const Piercing& piercing : piercings)
            curve.push_back(point_of(piercing, a, b));
    }
    return curves;
}

/// How deep two bodies are in each other: the length of their overlap along its separation direction [m].
double depth_of(const Overlap& overlap, const std::vector<Curve>& curves, const StillSurface& a,
                const StillSurface& b)
{
    double lowest = INFINITY, highest = -INFINITY;
    const auto add = [&](const Vec3& point) {
        const double along = overlap.separation_direction.dot(point);
        lowest = std::min(lowest, along);
        highest = std::max(highest, along);
    };
    for (const int vertex : overlap.vertices_of_a)
        add(a.positions[vertex]);
    for (const int vertex : overlap.vertices_of_b)
        add(b.positions[vertex]);
    for (const Curve& curve : curves)
        std::for_each(curve.begin(), curve.end(), add);
    return highest - lowest;
}

/// The vertices that are nearer to a curve than `reach` [m].
std::vector<int> vertices_at(const Curve& curve, std::span<const Vec3> positions, double reach)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : curve)
        box.extend(point);
    const auto reaches = [&](const Vec3& x) {
        for (std::size_t i = 0; i < curve.size(); ++i)
            if (const Vec3& to = curve[(i + 1) % curve.size()];
                closest_on_triangle(x, curve[i], to, to).distance <= reach)
                return true;
        return false;
    };
    std::vector<int> near;
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
        if (box.exteriorDistance(positions[vertex]) <= reach && reaches(positions[vertex]))
            near.push_back(static_cast<int>(vertex));
    return near;
}

}  // namespace

void InsidePairs::fit_trees(const World& world)
{
    const bool same = std::equal(bodies_.begin(), bodies_.end(), world.bodies.begin(), world.bodies.end(),
                                 [](const Body* one, const auto& other) { return one == other.get(); });
    if (!same) {
        bodies_.clear();
        trees_.clear();
        closed_.clear();
        for (const auto& body : world.bodies) {
            bodies_.push_back(body.get());
            trees_.emplace_back(body->surface(), body->contact_t0());
            closed_.push_back(body->surface().is_closed());
        }
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        trees_[i].refit({bodies_[i]->surface(), bodies_[i]->contact_t0(), bodies_[i]->contact_t0()});
}

StillSurface InsidePairs::still(int body) const
{
    return {bodies_[body]->surface(), bodies_[body]->contact_t0(), trees_[body]};
}

void InsidePairs::trace(const World& world)
{
    fit_trees(world);
    overlaps_.clear();
    std::vector<SweptBox> boxes;
    boxes.reserve(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        boxes.push_back(closed_[i] ? trees_[i].box() : SweptBox::empty());
    for (const auto& [a, b] : overlapping_bodies(boxes))
        if (bodies_may_meet(world, a, b))
            if (auto found = find_overlaps(still(a), still(b)); !found.empty())
                overlaps_.push_back({a, b, std::move(found)});
}

//! [left_out]
LeftOut InsidePairs::left_out(const std::function<double(int, int)>& touching) const
{
    LeftOut left_out;
    const auto add_vertices = [&](int body, const std::vector<int>& vertices, int other) {
        for (const int vertex : vertices) {
            left_out.vertices.insert({body, vertex, other});
            for (const int edge : bodies_[body]->surface().edges_around_vertex(vertex))
                left_out.edges.insert({body, edge, other});
        }
    };
    for (const auto& [a, b, overlaps] : overlaps_)
        for (const Overlap& overlap : overlaps) {
            add_vertices(a, overlap.vertices_of_a, b);
            add_vertices(b, overlap.vertices_of_b, a);
            for (const std::vector<Piercing>& curve : overlap.curves)
                for (const auto& [of_a, edge, face, entry] : curve)
                    left_out.edges.insert(of_a ? std::tuple{a, edge, b} : std::tuple{b, edge, a});
            const std::vector<Curve> curves = curves_around(overlap, still(a), still(b));
            const double reach = std::max(touching(a, b), depth_of(overlap, curves, still(a), still(b)));
            for (const Curve& curve : curves) {
                add_vertices(a, vertices_at(curve, still(a).positions, reach), b);
                add_vertices(b, vertices_at(curve, still(b).positions, reach), a);
            }
        }
    return left_out;
}
//! [left_out]

void InsidePairs::append_pairs(const World& world, Contacts& contacts)
{
    direction_of_vertex_.clear();
    const VertexContacts in_contact(contacts);
    const auto append_of = [&](int body_a, const std::vector<int>& vertices, int body_b,
                               const Vec3& direction) {
        append_pairs_of(body_a, still(body_a), vertices, body_b, still(body_b), direction, in_contact,
                        contacts);
        for (const int vertex : vertices)
            direction_of_vertex_[{body_a, vertex, body_b}] = direction;
    };
    for (const auto& [i, j, overlaps] : overlaps_)
        for (const Overlap& overlap : overlaps) {
            append_of(i, overlap.vertices_of_a, j, overlap.separation_direction);
            append_of(j, overlap.vertices_of_b, i, -overlap.separation_direction);
            append_crossing_edges(world, i, j, overlap, contacts);
        }
}

//! [part_along_direction]
double InsidePairs::part_along_direction(const World& world, const Contact& contact) const
{
    for (int i = 0; contact.kind != ContactKind::vertex_plane && i < contact.vertex_count(); ++i) {
        const bool of_a = i < contact.vertices_of_a();
        const auto direction = direction_of_vertex_.find({of_a ? contact.body_a : contact.body_b,
                                                          contact.vertices[static_cast<std::size_t>(i)],
                                                          of_a ? contact.body_b : contact.body_a});
        if (direction != direction_of_vertex_.end())
            return std::max(
                0.0, (of_a ? 1 : -1) * direction->second.dot(contact_geometry(world, contact, 0).normal));
    }
    return 1;
}
//! [part_along_direction]

}  // namespace enduring
