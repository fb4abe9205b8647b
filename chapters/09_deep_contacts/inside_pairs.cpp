#include "chapters/09_deep_contacts/inside_pairs.hpp"

#include "chapters/06_redefinition/contact_index.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "chapters/09_deep_contacts/crossing_edges.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

//! [append]
/// A pair for each of the vertices that has none with the other body.
void append_pairs_of(int body_a, const StillSurface& inner, const std::vector<int>& vertices, int body_b,
                     const StillSurface& other, const std::vector<Vec3>& ways,
                     const VertexContacts& in_contact, Contacts& contacts)
{
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const int vertex = vertices[i];
        if (in_contact.find(body_a, vertex, body_b) >= 0)
            continue;
        const Exit exit = find_exit(other, inner.positions[vertex], ways[i]);
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

//! [way_of_pairs]
/// The way on which an overlap's pairs let its bodies out. It is theirs if none of them leads along the way out,
/// as half-way through a body, where a hair decides which way is the shorter one: they would wait for each other.
Vec3 way_of_pairs(const World& world, const Contacts& contacts, const VertexContacts& in_contact,
                  const Overlap& overlap, int body_a, int body_b)
{
    Vec3 sum = Vec3::Zero();
    double most = -1;
    const auto add = [&](int inner, const std::vector<int>& vertices, int outer, double sign) {
        for (const int vertex : vertices) {
            const int index = in_contact.find(inner, vertex, outer);
            if (index < 0 || !contacts[index].is_spring())
                continue;
            const Vec3 normal = sign * contact_geometry(world, contacts[index], 0).normal;
            sum += normal;
            most = std::max(most, normal.dot(overlap.way_out));
        }
    };
    add(body_a, overlap.vertices_of_a, body_b, 1);
    add(body_b, overlap.vertices_of_b, body_a, -1);
    return most <= 0 && sum.norm() > tolerance::cancelled ? sum.normalized() : overlap.way_out;
}
//! [way_of_pairs]

StillSurface still(const Body& body, const FaceTree& tree)
{
    return {body.surface(), body.positions_t0(), tree};
}

}  // namespace

std::vector<Vec3> shared_way_out(const StillSurface&, const std::vector<int>& vertices, const StillSurface&,
                                 const Vec3& way_out)
{
    return std::vector<Vec3>(vertices.size(), way_out);
}

void InsidePairs::fit_trees(const World& world)
{
    const bool same = std::equal(bodies_.begin(), bodies_.end(), world.bodies.begin(), world.bodies.end(),
                                 [](const Body* one, const auto& other) { return one == other.get(); });
    if (!same) {
        bodies_.clear();
        trees_.clear();
        for (const auto& body : world.bodies) {
            bodies_.push_back(body.get());
            trees_.emplace_back(body->surface(), body->positions_t0());
        }
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        trees_[i].refit({bodies_[i]->surface(), bodies_[i]->positions_t0(), bodies_[i]->positions_t0()});
}

void InsidePairs::note_ways(int body_a, const std::vector<int>& vertices, int body_b,
                            const std::vector<Vec3>& ways)
{
    for (std::size_t i = 0; i < vertices.size(); ++i)
        way_of_vertex_[{body_a, vertices[i], body_b}] = ways[i];
}

//! [append_missing]
void InsidePairs::append_missing(const World& world, Contacts& contacts)
{
    fit_trees(world);
    way_of_vertex_.clear();
    const VertexContacts in_contact(contacts);
    const int count = static_cast<int>(bodies_.size());
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j) {
            const Body &a = *bodies_[i], &b = *bodies_[j];
            if ((a.is_static() && b.is_static()) || !a.surface().is_closed() || !b.surface().is_closed() ||
                !trees_[i].box().overlaps(trees_[j].box()))
                continue;
            const StillSurface still_a = still(a, trees_[i]), still_b = still(b, trees_[j]);
            for (const Overlap& overlap : find_overlaps(still_a, still_b)) {
                const auto &of_a = overlap.vertices_of_a, &of_b = overlap.vertices_of_b;
                const Vec3 way_out = way_of_pairs(world, contacts, in_contact, overlap, i, j);
                const std::vector<Vec3> ways_a = ways_(still_a, of_a, still_b, way_out),
                                        ways_b = ways_(still_b, of_b, still_a, -way_out);
                append_pairs_of(i, still_a, of_a, j, still_b, ways_a, in_contact, contacts);
                append_pairs_of(j, still_b, of_b, i, still_a, ways_b, in_contact, contacts);
                append_crossing_edges(world, i, j, overlap, way_out, contacts);
                note_ways(i, of_a, j, ways_a);
                note_ways(j, of_b, i, ways_b);
            }
        }
}
//! [append_missing]

//! [fade_slack]
void fade_slack(Contacts& contacts, double keep, const std::function<double(const Contact&)>& most)
{
    for (Contact& contact : contacts)
        if (contact.slack < 0)
            contact.slack = std::min(keep * contact.slack, contact.slack + most(contact));
}

double InsidePairs::part_along_the_way(const World& world, const Contact& contact) const
{
    for (int i = 0; contact.kind != ContactKind::vertex_plane && i < contact.vertex_count(); ++i) {
        const bool of_a = i < contact.vertices_of_a();
        const auto way = way_of_vertex_.find({of_a ? contact.body_a : contact.body_b,
                                              contact.vertices[static_cast<std::size_t>(i)],
                                              of_a ? contact.body_b : contact.body_a});
        if (way != way_of_vertex_.end())
            return std::max(0.0,
                            (of_a ? 1 : -1) * way->second.dot(contact_geometry(world, contact, 0).normal));
    }
    return 1;
}
//! [fade_slack]

}  // namespace enduring
