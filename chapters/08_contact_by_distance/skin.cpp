#include "chapters/08_contact_by_distance/skin.hpp"

#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/near_pairs.hpp"
#include "chapters/08_contact_by_distance/own_directions.hpp"

#include <algorithm>
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
    return distance_parts.skin * (body.is_static() ? std::min(smallest, body.size()) : body.size());
}

}  // namespace

void Skins::put(World& world)
{
    const double smallest = smallest_size(world);
    for (const auto& body : world.bodies) {
        Skin skin{world.skins.empty() ? thickness_of(*body, smallest) : world.skins[skins_.size()], 0};
        if (body->surface().is_closed() && keeps_shape(*body) && skin.thickness > 0) {
            const std::span<const Vec3> own = body->shape();
            const std::vector<Vec3> inset = inset_surface(body->surface(), own, skin.thickness);
            for (std::size_t v = 0; v < inset.size(); ++v)
                skin.recess = std::max(skin.recess, (inset[v] - own[v]).norm());
            body->take_contact_surface(inset);
        }
        skins_.push_back(skin);
    }
}

//! [fit_gaps]
void Skins::fit_gaps(World& world, const CandidateSearch& search)
{
    if (!world.skins.empty())  // a run that goes on
        return;
    for (const Skin& skin : skins_)
        world.skins.push_back(skin.thickness);
    const auto fit = [&](int a, int b, double distance) {
        if (distance < gap(a, b))
            for (const int body : {a, b}) {
                double& thickness = world.skins[static_cast<std::size_t>(body)];
                thickness = std::min(
                    thickness, std::max(0.5 * distance, distance_parts.least_skin * of(body).thickness));
            }
    };
    search.visit_candidates(
        [&](int a, int vertex, int b, int face) {
            fit(a, b,
                closest_on_face(surface_of(world, a).start(vertex), surface_of(world, b), face).distance);
        },
        [&](int a, int edge_a, int b, int edge_b) {
            const auto closest = closest_inside(surface_of(world, a), edge_a, surface_of(world, b), edge_b);
            if (closest)
                fit(a, b, closest->difference.norm());
        });
    for (std::size_t body = 0; body < skins_.size(); ++body)
        skins_[body].thickness = world.skins[body];
}
//! [fit_gaps]

double Skins::distance(int a, int b) const { return of(a).recess + of(b).recess + gap(a, b); }

double Skins::gap(int a, int b) const
{
    return of(a).recess + of(b).recess > 0 ? 0 : of(a).thickness + of(b).thickness;
}

}  // namespace enduring
