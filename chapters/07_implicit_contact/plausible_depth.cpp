#include "chapters/07_implicit_contact/plausible_depth.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

bool pushes(const Contact& contact, int body)
{
    return contact.is_spring() && contact.category != ContactCategory::hooked &&
           (contact.body_a == body || (contact.kind != ContactKind::vertex_plane && contact.body_b == body));
}

double way_in_step(const World& world, const Contact& contact)
{
    const ContactGeometry start = contact_geometry(world, contact, 0),
                          end = contact_geometry(world, contact, 1);
    return ((end.p - end.q) - (start.p - start.q)).norm();
}

}  // namespace

//! [plausible_depth]
/// How much deeper than the places at which a body is pushed its other corners can have sunk beside them.
constexpr double lever = 10;

double plausible_depth(const World& world, std::span<const Contact> others, const Contact& contact)
{
    double deepest = 0;
    for (const Contact& other : others)
        if (pushes(other, contact.body_a) || pushes(other, contact.body_b))
            deepest = std::max(deepest, -contact_geometry(world, other, 0).depth);
    return lever * deepest + way_in_step(world, contact);
}
//! [plausible_depth]

void drop_implausible(const World& world, Contacts& contacts, std::size_t first, double tau)
{
    const auto new_ones = contacts.begin() + static_cast<std::ptrdiff_t>(first);
    const std::span<const Contact> others(contacts.begin(), new_ones);
    contacts.erase(std::remove_if(new_ones, contacts.end(),
                                  [&](const Contact& pair) {
                                      return -contact_geometry(world, pair, tau).depth >
                                             plausible_depth(world, others, pair);
                                  }),
                   contacts.end());
}

}  // namespace enduring
