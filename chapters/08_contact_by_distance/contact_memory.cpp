#include "chapters/08_contact_by_distance/contact_memory.hpp"

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "common/geometry/shortest_turn.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace enduring {
namespace {

bool is_remembered(const Contact& contact) { return contact.spring.stiffness > 0; }

/// Of a vertex against a body, whatever the face.
using VertexKey = std::tuple<int, int, int>;
VertexKey vertex_key(const Contact& contact) { return {contact.body_a, contact.feature_a, contact.body_b}; }

//! [hand_on]
/// Takes over from a face that the vertex has left: its spring stays compressed as it was, its stretch turns
/// with the surface.
bool hand_on(const World& world, const Contact& last, Contact& contact)
{
    const ContactGeometry before = contact_geometry(world, last, 0),
                          now = contact_geometry(world, contact, contact.start);
    if (before.normal.dot(now.normal) < distance_parts.hand_on)
        return false;
    contact.spring = last.spring;
    contact.spring.rest_offset = std::min(0.0,
                                          now.depth - std::min(0.0, before.depth - last.spring.rest_offset));
    contact.spring.stretch = shortest_turn(before.normal, now.normal) * last.spring.stretch;
    return true;
}
//! [hand_on]

}  // namespace

//! [remember]
void remember(const World& world, const Contacts& last, Contacts& found)
{
    std::map<PairKey, const Contact*> by_key;
    for (const Contact& contact : last)
        by_key[key_of(contact)] = &contact;
    for (Contact& contact : found)
        if (const auto same = by_key.find(key_of(contact)); same != by_key.end()) {
            contact.spring = same->second->spring;
            by_key.erase(same);
        }
    std::multimap<VertexKey, const Contact*> left_over;
    for (const auto& [key, contact] : by_key)
        if (contact->kind == ContactKind::vertex_face)
            left_over.emplace(vertex_key(*contact), contact);
    for (Contact& contact : found) {
        if (is_remembered(contact) || contact.kind != ContactKind::vertex_face)
            continue;
        const auto [first, end] = left_over.equal_range(vertex_key(contact));
        const auto from = std::find_if(
            first, end, [&](const auto& entry) { return hand_on(world, *entry.second, contact); });
        if (from != end)
            left_over.erase(from);
    }
}
//! [remember]

}  // namespace enduring
