#include "chapters/09_deep_contacts/inside_pairs.hpp"

#include "chapters/02_collision_detection/body_broad_phase.hpp"
#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/02_collision_detection/slabs.hpp"
#include "chapters/06_redefinition/contact_index.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "common/geometry/closest_points.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

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

void InsidePairs::build(const World& world)
{
    bodies_.clear();
    trees_.clear();
    is_closed_.clear();
    fitted_.assign(world.bodies.size(), {});
    traced_.clear();
    for (const auto& body : world.bodies) {
        bodies_.push_back(body.get());
        trees_.emplace_back(body->surface(), body->contact_t0());
        is_closed_.push_back(body->surface().is_closed());
    }
}

/// @return  for each body, whether it lies elsewhere than at the last trace
std::vector<bool> InsidePairs::fit_trees(const World& world)
{
    const bool same = std::equal(bodies_.begin(), bodies_.end(), world.bodies.begin(), world.bodies.end(),
                                 [](const Body* one, const auto& other) { return one == other.get(); });
    if (!same)
        build(world);
    std::vector<bool> moved(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const std::span<const Vec3> positions = bodies_[i]->contact_t0();
        moved[i] = !std::equal(positions.begin(), positions.end(), fitted_[i].begin(), fitted_[i].end());
        if (!moved[i])
            continue;
        trees_[i].refit({bodies_[i]->surface(), positions, positions});
        fitted_[i].assign(positions.begin(), positions.end());
    }
    return moved;
}

StillSurface InsidePairs::still(int body) const
{
    return {bodies_[body]->surface(), bodies_[body]->contact_t0(), trees_[body]};
}

//! [trace]
void InsidePairs::trace(const World& world)
{
    const std::vector<bool> moved = fit_trees(world);
    std::vector<SweptBox> boxes;
    for (std::size_t i = 0; i < trees_.size(); ++i)
        boxes.push_back(is_closed_[i] ? trees_[i].box() : SweptBox::empty());
    BodySlabs slabs(boxes, [&](std::size_t i) {
        const std::span<const Vec3> positions = bodies_[i]->contact_t0();
        return slabs_along_faces({bodies_[i]->surface(), positions, positions}, 0);
    });
    std::vector<BodyOverlaps> before;
    before.swap(traced_);
    auto last = before.begin();
    for (const auto& [a, b] : overlapping_bodies(boxes)) {
        if (!bodies_may_meet(world, a, b) ||
            slabs.keep_apart(static_cast<std::size_t>(a), static_cast<std::size_t>(b)))
            continue;
        // a step that is taken in halves begins where the whole one did
        const bool is_known = !moved[a] && !moved[b] && find_onwards(last, before.end(), {a, b});
        traced_.push_back({a, b, is_known ? std::move(last->overlaps) : find_overlaps(still(a), still(b))});
    }
}
//! [trace]

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
    for (const auto& [a, b, overlaps] : traced_)
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
    for (const auto& [i, j, overlaps] : traced_)
        for (const Overlap& overlap : overlaps) {
            append_of(i, overlap.vertices_of_a, j, overlap.separation_direction);
            append_of(j, overlap.vertices_of_b, i, -overlap.separation_direction);
            append_crossing_edges(world, i, j, overlap, contacts);
        }
}

//! [part_along_direction]
double InsidePairs::part_along_direction(const World& world, const Contact& contact) const
{
    for (int i = 0; !contact.on_plane() && i < contact.vertex_count(); ++i) {
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
