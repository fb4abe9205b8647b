#include "chapters/03_penalty_impulses/penalty_contact.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

double depth_at_start(const World& world, const Contact& contact)
{
    const PairInstant start = pair_step(world, contact).t0;
    return start.side_1.cross(start.side_2).dot(start.offset);
}

}  // namespace

//! [resolve]
void resolve_separated_pairs(const World& world, Contacts& contacts)
{
    const auto separated = [&](const Contact& contact) {
        return contact.kind != ContactKind::vertex_plane && depth_at_start(world, contact) > 0;
    };
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(), separated), contacts.end());
}
//! [resolve]

}  // namespace enduring
