#include "chapters/01_particle_plane/plane_contact.hpp"

#include "chapters/01_particle_plane/plane_impulse.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <vector>

namespace enduring {
namespace {

/// Signed depths of a vertex at both ends of the step [m].
struct PlaneStep {
    double depth_t0, depth_t1;
};

PlaneStep plane_step(const Body& body, int vertex, const Plane& plane)
{
    const auto v = static_cast<std::size_t>(vertex);
    return {plane.normal.dot(body.positions_t0()[v] - plane.point),
            plane.normal.dot(body.positions_t1()[v] - plane.point)};
}

PlaneStep plane_step(const World& world, const Contact& contact)
{
    return plane_step(*world.bodies[contact.body_a], contact.feature_a, world.planes[contact.body_b]);
}

/// A body's vertex and a plane.
struct PlanePair {
    int body, plane, vertex;
    auto operator<=>(const PlanePair&) const = default;
};

/// Those that have a contact already, ascending.
std::vector<PlanePair> pairs_in_contact(const Contacts& contacts)
{
    std::vector<PlanePair> pairs;
    for (const Contact& contact : contacts)
        if (contact.on_plane())
            pairs.push_back({contact.body_a, contact.body_b, contact.feature_a});
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

Contact new_contact(int body, int vertex, int plane, double start)
{
    Contact contact;
    contact.kind = ContactKind::vertex_plane;
    contact.body_a = body;
    contact.body_b = plane;
    contact.feature_a = vertex;
    contact.vertices[0] = vertex;
    contact.weights[0] = 1;
    contact.start = start;
    return contact;
}

void detect(const World& world, int body_index, int plane_index, const std::vector<PlanePair>& known,
            Contacts& contacts)
{
    const Body& body = *world.bodies[body_index];
    const Plane& plane = world.planes[plane_index];
    for (int vertex = 0; vertex < body.surface().vertex_count(); ++vertex) {
        const PlaneStep step = plane_step(body, vertex, plane);
        const auto inside = find_plane_interval(step.depth_t0, step.depth_t1);
        if (inside &&
            !std::binary_search(known.begin(), known.end(), PlanePair{body_index, plane_index, vertex}))
            contacts.push_back(new_contact(body_index, vertex, plane_index, inside->begin));
    }
}

}  // namespace

void detect_plane_contacts(World& world, Contacts& contacts)
{
    const std::vector<PlanePair> known = pairs_in_contact(contacts);
    for (std::size_t body = 0; body < world.bodies.size(); ++body)
        if (!world.bodies[body]->is_static())
            for (std::size_t plane = 0; plane < world.planes.size(); ++plane)
                detect(world, static_cast<int>(body), static_cast<int>(plane), known, contacts);
}

void resolve_plane_contacts(World& world, Contacts& contacts)
{
    const auto left_the_ground = [&](const Contact& contact) {
        return contact.on_plane() && plane_step(world, contact).depth_t0 > 0;
    };
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(), left_the_ground), contacts.end());
}

//! [laws]
Vec3 discrete_on_plane(const PairStep& step, double, double k, double dt)
{
    const Vec3& n = step.plane_normal.value();
    return discrete_plane_impulse(n.dot(step.t1.offset), k, dt) * n;
}

Vec3 continuous_on_plane(const PairStep& step, double, double k, double dt)
{
    const Vec3& n = step.plane_normal.value();
    return continuous_plane_impulse(n.dot(step.t0.offset), n.dot(step.t1.offset), k, dt) * n;
}
//! [laws]

NormalLaw plane_law(const ContactParameters& parameters)
{
    if (parameters.law)
        return parameters.law;
    constexpr std::array laws{discrete_on_plane, continuous_on_plane};  // as PenaltyMethod has them
    return laws.at(static_cast<std::size_t>(parameters.method));
}

//! [respond]
void push_apart(const World& world, Contacts& contacts, const NormalLaw& law, double stiffness, double dt)
{
    for (Contact& contact : contacts)
        if (contact.waiting())
            contact.impulse = law(pair_step(world, contact), contact.start,
                                  pair_stiffness(world, contact, stiffness), dt);
}
//! [respond]

}  // namespace enduring
