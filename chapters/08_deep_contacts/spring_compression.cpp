#include "chapters/08_deep_contacts/spring_compression.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

double depth_of(const World& world, const Contact& contact)
{
    return contact_geometry(world, contact, 0).depth;
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
                                c.held(),
                                std::min(0.0, depth_of(world, c) - c.slack)});
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
        if (spring == springs_.end() || spring->key != key)
            continue;
        if (spring->held)
            contact.slack = std::min(0.0, depth_of(world, contact));
        else if (spring->face != contact.feature_b)
            contact.slack = std::min(0.0, depth_of(world, contact) - spring->compression);
    }
}
//! [keep]

}  // namespace enduring
