#include "chapters/09_deep_contacts/inside_pairs.hpp"

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/06_redefinition/contact_index.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

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

}  // namespace

void InsidePairs::fit_trees(const World& world)
{
    const bool same = std::equal(bodies_.begin(), bodies_.end(), world.bodies.begin(), world.bodies.end(),
                                 [](const Body* one, const auto& other) { return one == other.get(); });
    if (!same) {
        bodies_.clear();
        trees_.clear();
        for (const auto& body : world.bodies) {
            bodies_.push_back(body.get());
            trees_.emplace_back(body->surface(), body->contact_t0());
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
    const int count = static_cast<int>(bodies_.size());
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j) {
            const Body &a = *bodies_[i], &b = *bodies_[j];
            if (!a.surface().is_closed() || !b.surface().is_closed() ||
                !trees_[i].box().overlaps(trees_[j].box()) || !bodies_may_meet(world, i, j))
                continue;
            if (auto found = find_overlaps(still(i), still(j)); !found.empty())
                overlaps_.push_back({i, j, std::move(found)});
        }
}

std::vector<std::pair<int, int>> InsidePairs::overlapping_bodies() const
{
    std::vector<std::pair<int, int>> bodies;
    for (const BodyOverlaps& overlap : overlaps_)
        bodies.emplace_back(overlap.a, overlap.b);
    return bodies;
}

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
