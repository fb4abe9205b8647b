#include "chapters/01_particle_plane/normal_response.hpp"

#include "chapters/01_particle_plane/plane_impulse.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <array>

namespace enduring {

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
