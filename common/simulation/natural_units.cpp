#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

//! [natural_units]
NaturalUnits natural_units(double length, double gravity, double dt)
{
    if (gravity > 0)
        return {length, std::sqrt(gravity * length)};
    return {length, length / (scale_parts.weightless_steps * dt)};
}

double natural_length(const World& world, const Contact& contact)
{
    double length = world.bodies[contact.body_a]->size();
    if (!contact.on_plane())
        length = std::min(length, world.bodies[contact.body_b]->size());
    return length > 0 ? length : NaturalUnits{}.length;  // points have none
}

NaturalUnits natural_units(const World& world, const Contact& contact, double dt)
{
    return natural_units(natural_length(world, contact), world.gravity.norm(), dt);
}
//! [natural_units]

double max_depenetration_velocity(const World& world, const Contact& contact, std::optional<double> of_scene,
                                  double dt)
{
    return of_scene ? *of_scene
                    : scale_parts.max_depenetration_velocity * natural_units(world, contact, dt).speed;
}

}  // namespace enduring
