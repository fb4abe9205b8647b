#include "chapters/03_penalty_impulses/penalty_contact.hpp"

#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

PairInstant instant(const Contact& contact, const PairVertices& x)
{
    return contact.kind == ContactKind::vertex_face ? vertex_face_instant(x) : edge_edge_instant(x, contact.orientation);
}

double depth_at_start(const World& world, const Contact& contact)
{
    const PairInstant start = pair_step(world, contact).t0;
    return start.side_1.cross(start.side_2).dot(start.offset);
}

}  // namespace

PairStep pair_step(const World& world, const Contact& contact)
{
    PairVertices t0, t1;
    for (std::size_t i = 0; i < 4; ++i) {
        const Body& body = body_of_vertex(world, contact, static_cast<int>(i));
        const auto vertex = static_cast<std::size_t>(contact.vertices[i]);
        t0[i] = body.positions_t0()[vertex];
        t1[i] = body.positions_t1()[vertex];
    }
    return {instant(contact, t0), instant(contact, t1)};
}

//! [resolve]
void resolve_separated_pairs(const World& world, Contacts& contacts)
{
    const auto separated = [&](const Contact& contact) {
        return contact.kind != ContactKind::vertex_plane && depth_at_start(world, contact) > 0;
    };
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(), separated), contacts.end());
}
//! [resolve]

//! [respond]
void push_pairs_apart(const World& world, Contacts& contacts, PenaltyMethod method, double stiffness, double dt)
{
    for (Contact& contact : contacts) {
        if (contact.kind == ContactKind::vertex_plane || !contact.waiting())
            continue;
        const PairStep step = pair_step(world, contact);
        contact.impulse = method == PenaltyMethod::discrete ? discrete_impulse(step.t1, stiffness, dt)
                                                            : continuous_impulse(step, contact.start, stiffness, dt);
    }
}
//! [respond]

}  // namespace enduring
