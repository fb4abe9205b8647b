#include "chapters/09_deep_contacts/spring_compression.hpp"

#include "common/geometry/triangle_distance.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>

namespace enduring {
namespace {

double depth_of(const World& world, const Contact& contact)
{
    return contact_geometry(world, contact, 0).depth;
}

/// Of the vertex from the face [m].
double distance_to_face(const World& world, const Contact& contact)
{
    const auto x = [&](int i) { return contact_vertex(world, contact, i, 0); };
    return distance_to_triangle(x(0), x(1), x(2), x(3));
}

bool has_spring(const Contact& contact)
{
    return contact.kind == ContactKind::vertex_face && !contact.resolved && contact.stiffness > 0;
}

}  // namespace

void SpringCompressions::note(const World& world, const Contacts& contacts)
{
    springs_.clear();
    for (const Contact& c : contacts)
        if (has_spring(c))
            springs_.push_back({{c.body_a, c.feature_a, c.body_b},
                                c.feature_b,
                                std::min(0.0, depth_of(world, c) - c.slack),
                                distance_to_face(world, c)});
    std::sort(springs_.begin(), springs_.end(),
              [](const Spring& one, const Spring& other) { return one.key < other.key; });
}

//! [keep]
void SpringCompressions::keep(const World& world, Contacts& contacts) const
{
    for (Contact& contact : contacts) {
        if (!has_spring(contact) || contact.held())
            continue;
        const Key key{contact.body_a, contact.feature_a, contact.body_b};
        const auto spring = std::lower_bound(
            springs_.begin(), springs_.end(), key,
            [](const Spring& one, const Key& sought) { return one.key < sought; });
        // by how much a body that rests is pressed in deeper than a face that it has left
        const double tolerance = scale_parts.other_face * natural_length(world, contact);
        if (spring == springs_.end() || spring->key != key)
            continue;
        if (spring->face != contact.feature_b && -depth_of(world, contact) > spring->distance + tolerance)
            contact.resolved = true;  // no motion has led there: it has left its face, and that is all
        else if (spring->face != contact.feature_b)
            contact.slack = std::min(0.0, depth_of(world, contact) - spring->compression);
    }
}
//! [keep]

}  // namespace enduring
