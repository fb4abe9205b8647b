#include "chapters/contact_by_distance/skin.hpp"

#include "chapters/contact_by_distance/distance_parts.hpp"
#include "chapters/contact_by_distance/own_directions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enduring {
namespace {

/// Of the bodies that move [m]; infinite if none does.
double smallest_size(const World& world)
{
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& body : world.bodies)
        if (!body->is_static())
            smallest = std::min(smallest, body->size());
    return smallest;
}

double thickness_of(const Body& body, double smallest)
{
    const double size = body.is_static() ? std::min(smallest, body.size()) : body.size();
    const double of_size = distance_parts.skin * size;
    // the size of a closed body is 6 V / A
    return body.surface().is_closed() ? std::min(of_size, distance_parts.of_thickness * 0.5 * body.size())
                                      : of_size;
}

}  // namespace

void Skins::put(World& world)
{
    if (!skins_.empty() && world.time != time_)
        return;
    const bool first = skins_.empty();
    const double smallest = smallest_size(world);
    for (std::size_t i = 0; first && i < world.bodies.size(); ++i) {
        const Body& body = *world.bodies[i];
        Skin skin{thickness_of(body, smallest), 0};
        surfaces_.emplace_back();
        if (body.surface().is_closed() && keeps_shape(body) && skin.thickness > 0) {
            skin.inset = skin.thickness;
            surfaces_.back() = inset_surface(body.surface(), body.placed(), skin.inset);
        }
        skins_.push_back(skin);
    }
    time_ = world.time;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        if (!surfaces_[i].empty())
            world.bodies[i]->take_contact_surface(surfaces_[i]);
}

double Skins::gap(const Contact& contact) const
{
    return contact.kind == ContactKind::vertex_plane ? of(contact.body_a).inset
                                                     : between(contact.body_a, contact.body_b);
}

}  // namespace enduring
