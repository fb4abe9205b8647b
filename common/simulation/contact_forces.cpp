#include "common/simulation/contact_forces.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enduring {

//! [last_part]
double last_part(const World& world, double dt)
{
    // A body is told the time at which each part of a step begins; one that moves as given is already at its
    // end.
    double began = world.time;
    for (const auto& body : world.bodies)
        began = std::min(began, body->time());
    const double elapsed = world.time - began;
    if (!(elapsed > 0))
        return dt;
    // A difference of times is rounded; a part is not.
    const double part = dt * std::exp2(std::round(std::log2(elapsed / dt)));
    return part < dt ? part : dt;
}
//! [last_part]

std::vector<std::vector<Vec3>> vertex_forces(const World& world, const Contacts& contacts, double dt)
{
    const double part = last_part(world, dt);
    std::vector<std::vector<Vec3>> forces;
    forces.reserve(world.bodies.size());
    for (const auto& body : world.bodies)
        forces.emplace_back(body->positions_t0().size(), Vec3::Zero());
    for (const Contact& contact : contacts) {
        const Vec3 force = pair_force(contact, part).total();
        for (int i = 0; i < contact.vertex_count(); ++i) {
            const auto at = static_cast<std::size_t>(i);
            const auto vertex = static_cast<std::size_t>(contact.vertices[at]);
            forces[body_index(contact, i)][vertex] += contact.weights[at] * force;
        }
    }
    return forces;
}

std::vector<Vec3> body_forces(const World& world, const Contacts& contacts, double dt)
{
    std::vector<Vec3> sums;
    sums.reserve(world.bodies.size());
    for (const std::vector<Vec3>& forces : vertex_forces(world, contacts, dt))
        sums.push_back(std::accumulate(forces.begin(), forces.end(), Vec3(Vec3::Zero())));
    return sums;
}

}  // namespace enduring
