#include "chapters/06_redefinition/edge_edge_dismissal.hpp"

#include "chapters/05_categorisation/category.hpp"

namespace enduring {
namespace {

//! [dismiss]
void dismiss_or_hold(const World& world, Contact& contact)
{
    const PairSurfaces surfaces(world, contact, 0);
    const PairVertices x = edge_vertices(surfaces, contact.feature_a, contact.feature_b);
    const std::optional<EdgeFeet> feet = feet_of_edges(x, contact.orientation, smallest_edge_sine);
    if (!feet)
        return contact.hold(true);

    put_at(contact, *feet);
    const bool hooked = is_hooked_edge_pair(surfaces.a, contact.feature_a, surfaces.b, contact.feature_b,
                                            feet->normal);
    contact.category = hooked ? ContactCategory::hooked : ContactCategory::regular;
    contact.hold(hooked || !feet->overlap(0));
    contact.resolved = feet->depth > 0 || !feet->overlap(edge_tolerance);
}
//! [dismiss]

}  // namespace

void dismiss_enduring_edges(const World& world, Contacts& contacts)
{
    for (Contact& contact : contacts)
        if (contact.kind == ContactKind::edge_edge && !contact.resolved)
            dismiss_or_hold(world, contact);
}

}  // namespace enduring
