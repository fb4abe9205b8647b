#include "chapters/08_deep_contacts/inside_pairs.hpp"

#include "chapters/06_redefinition/contact_index.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "chapters/08_deep_contacts/overlaps.hpp"

#include <algorithm>

namespace enduring {
namespace {

//! [append]
/// A pair for each of the vertices that has none with the other body.
void append_pairs_of(const World& world, const VertexContacts& in_contact, int body_a,
                     const std::vector<int>& vertices, int body_b, const StillSurface& other, const Vec3& way,
                     Contacts& contacts)
{
    for (const int vertex : vertices) {
        if (in_contact.find(body_a, vertex, body_b) >= 0)
            continue;
        const Exit exit = find_exit(other, world.bodies[body_a]->positions_t0()[vertex], way);
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

StillSurface still(const Body& body, const FaceTree& tree)
{
    return {body.surface(), body.positions_t0(), tree};
}

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
            trees_.emplace_back(body->surface(), body->positions_t0());
        }
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        trees_[i].refit({bodies_[i]->surface(), bodies_[i]->positions_t0(), bodies_[i]->positions_t0()});
}

//! [append_missing]
void InsidePairs::append_missing(const World& world, Contacts& contacts)
{
    fit_trees(world);
    VertexContacts in_contact;
    in_contact.fill(contacts);
    const int count = static_cast<int>(bodies_.size());
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j) {
            const Body &a = *bodies_[i], &b = *bodies_[j];
            if ((a.is_static() && b.is_static()) || !a.surface().is_closed() || !b.surface().is_closed() ||
                !trees_[i].box().overlaps(trees_[j].box()))
                continue;
            const StillSurface still_a = still(a, trees_[i]), still_b = still(b, trees_[j]);
            for (const Overlap& overlap : find_overlaps(still_a, still_b)) {
                append_pairs_of(world, in_contact, i, overlap.vertices_of_a, j, still_b, overlap.way_out,
                                contacts);
                append_pairs_of(world, in_contact, j, overlap.vertices_of_b, i, still_a, -overlap.way_out,
                                contacts);
            }
        }
}
//! [append_missing]

//! [fade_slack]
void fade_slack(Contacts& contacts, double keep, double dt)
{
    for (Contact& contact : contacts)
        contact.slack = std::min(keep * contact.slack, contact.slack + leaving_speed * dt);
}
//! [fade_slack]

}  // namespace enduring
