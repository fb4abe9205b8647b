#include "chapters/04_friction/experiments/spring_energy.hpp"

#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>

namespace enduring::chapter04 {

double energy_with_springs(const World& world, const Contacts& contacts, const ContactParameters& parameters)
{
    double sum = friction_spring_energy(contacts, parameters.friction);
    for (const auto& body : world.bodies)
        sum += body->energy(world.gravity).total();
    for (const Contact& contact : contacts) {
        const double depth = std::min(0.0, contact_geometry(world, contact, 0).depth);
        sum += 0.5 * pair_stiffness(world, contact, parameters.stiffness) * depth * depth;
    }
    return sum;
}

SpringEnergyProbe::SpringEnergyProbe(std::string series, ContactParameters parameters)
    : TableProbe({"series", "time_s", "energy_j"}), series_(std::move(series)), parameters_(parameters)
{}

void SpringEnergyProbe::observe(const World& world, const Contacts& contacts, double)
{
    if (world.step == 0)
        return;  // the list of contacts is empty before the first step, though springs are pressed
    const double energy = energy_with_springs(world, contacts, parameters_);
    lowest_ = std::min(lowest_, energy);
    largest_rise_ = std::max(largest_rise_, energy - lowest_);
    table_.add({series_, world.time, energy});
}

}  // namespace enduring::chapter04
