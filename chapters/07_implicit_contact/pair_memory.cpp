#include "chapters/07_implicit_contact/pair_memory.hpp"

#include <algorithm>
#include <utility>

namespace enduring {

StiffnessChoice StiffnessChoice::of_pair(const NaturalUnits& units) const
{
    StiffnessChoice own = *this;
    own.wanted_depth = depth(units.length);
    own.max_depenetration_velocity = parts.fading_speed * units.speed;
    return own;
}

double wanted_stiffness(double mass, double load, const StiffnessChoice& choice, double dt)
{
    const double own = mass / (dt * dt);
    return std::min(std::max(choice.k_dt2_over_m * own, load / choice.depth()),
                    choice.max_k_dt2_over_m * own);
}

//! [stiffen]
void stiffen(Contact& contact, double depth_t0, double stiffness)
{
    const double before = std::exchange(contact.stiffness, stiffness),
                 compressed = depth_t0 - contact.rest_offset;
    if (compressed < 0) {
        contact.rest_offset = depth_t0 - compressed * before / stiffness;
        contact.stretch *= before / stiffness;
    }
}
//! [stiffen]

//! [adapt_stiffness]
void adapt_stiffness(Contact& contact, double depth_t0, double mass, const StiffnessChoice& choice, double dt,
                     double max_load)
{
    const double wanted = wanted_stiffness(mass, contact.load, choice, dt);
    if (contact.stiffness == 0) {
        contact.stiffness = wanted;
        contact.rest_offset = std::min(0.0, depth_t0);
        return;
    }
    const bool carries_its_load = contact.stiffness * (contact.rest_offset - depth_t0) <=
                                  choice.at_once * contact.load;  // else it is wound up, and would throw
    if (wanted > contact.stiffness || (choice.at_once * wanted < contact.stiffness && carries_its_load))
        stiffen(contact, depth_t0, wanted);
    // What moves out is not thrown, and a pair that cannot move out is not wound up for ever.
    const double at_most = depth_t0 + max_load / contact.stiffness;
    contact.rest_offset = std::min({choice.keep * contact.rest_offset,
                                    contact.rest_offset + choice.max_depenetration_velocity * dt,
                                    std::max(contact.rest_offset, at_most)});
}
//! [adapt_stiffness]

}  // namespace enduring
