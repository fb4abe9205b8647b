#include "chapters/07_implicit_contact/pair_memory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enduring {

StiffnessChoice StiffnessChoice::of_pair(const NaturalUnits& units) const
{
    StiffnessChoice own = *this;
    own.wanted_depth = depth(units.length);
    own.doubles_in = scale_parts.doubles_in * units.time();
    own.leaving_speed = scale_parts.fading_speed * units.speed;
    return own;
}

double wanted_stiffness(double mass, double load, const StiffnessChoice& choice, double dt)
{
    const double own = mass / (dt * dt);
    return std::min(std::max(choice.of_its_mass * own, load / choice.depth()), choice.most_of_its_mass * own);
}

//! [stiffen]
void stiffen(Contact& contact, double depth_t0, double stiffness)
{
    const double before = std::exchange(contact.stiffness, stiffness), compressed = depth_t0 - contact.slack;
    if (compressed < 0) {
        contact.slack = depth_t0 - compressed * before / stiffness;
        contact.stretch *= before / stiffness;
    }
}
//! [stiffen]

//! [adapt_stiffness]
void adapt_stiffness(Contact& contact, double depth_t0, double mass, const StiffnessChoice& choice, double dt,
                     double most_load)
{
    const double wanted = wanted_stiffness(mass, contact.load, choice, dt);
    if (contact.stiffness == 0) {
        contact.stiffness = wanted;
        contact.slack = std::min(0.0, depth_t0);
        return;
    }
    const double before = contact.stiffness;
    stiffen(contact, depth_t0, std::clamp(wanted, before, before * std::exp2(dt / choice.doubles_in)));
    // What moves out is not thrown, and a pair that cannot move out is not wound up for ever.
    const double at_most = depth_t0 + most_load / contact.stiffness;
    contact.slack = std::min({choice.keep * contact.slack, contact.slack + choice.leaving_speed * dt,
                              std::max(contact.slack, at_most)});
}
//! [adapt_stiffness]

}  // namespace enduring
