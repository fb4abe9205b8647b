#include "chapters/08_contact_by_distance/same_place.hpp"

#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/near_pairs.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <map>

namespace enduring {
namespace {

struct Place {
    std::size_t index;  ///< of the pair in the list
    Vec3 point;         ///< where it pushes, as the step begins
    Vec3 axis;          ///< along which, whatever the order of its bodies
};

bool is_same(const Place& one, const Place& other, double tolerance)
{
    return (one.point - other.point).norm() <= tolerance &&
           std::abs(one.axis.dot(other.axis)) >= distance_parts.hand_on;
}

/// Marks all but the first of those at one place.
void mark_others(std::vector<Place>& places, double tolerance, std::vector<bool>& marked)
{
    std::sort(places.begin(), places.end(), [](const Place& one, const Place& other) {
        return one.point.x() != other.point.x() ? one.point.x() < other.point.x() : one.index < other.index;
    });
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = i + 1;
             j < places.size() && places[j].point.x() - places[i].point.x() <= tolerance; ++j)
            if (is_same(places[i], places[j], tolerance))
                marked[std::max(places[i].index, places[j].index)] = true;
}

}  // namespace

void keep_one_at_each_place(const World& world, Contacts& contacts, std::size_t first)
{
    std::map<TwoBodies, std::vector<Place>> of_bodies;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& pair = contacts[i];
        if (pair.on_plane())
            continue;
        const ContactGeometry geometry = contact_geometry(world, pair, 0);
        of_bodies[std::minmax(pair.body_a, pair.body_b)].push_back(
            {i, 0.5 * (geometry.p + geometry.q), geometry.normal});
    }
    std::vector<bool> marked(contacts.size(), false);
    for (auto& [bodies, places] : of_bodies)
        mark_others(places,
                    distance_parts.same_place *
                        std::min(world.bodies[static_cast<std::size_t>(bodies.first)]->size(),
                                 world.bodies[static_cast<std::size_t>(bodies.second)]->size()),
                    marked);
    std::size_t next = 0;
    std::erase_if(contacts, [&](const Contact&) {
        const std::size_t i = next++;
        return i >= first && marked[i];
    });
}

}  // namespace enduring
