#include "chapters/07_implicit_contact/pair_memory.hpp"

#include <algorithm>

namespace enduring {

double wanted_stiffness(double mass, double load, const StiffnessChoice& choice, double dt)
{
    return std::max(choice.of_its_mass * mass / (dt * dt), load / choice.wanted_depth);
}

//! [adapt_stiffness]
void adapt_stiffness(Contact& contact, double depth_t0, double mass, const StiffnessChoice& choice, double dt)
{
    const double wanted = wanted_stiffness(mass, contact.load, choice, dt);
    if (contact.stiffness == 0) {
        contact.stiffness = wanted;
        contact.slack = std::min(0.0, depth_t0);
        return;
    }
    const double before = contact.stiffness, compressed = depth_t0 - contact.slack;
    contact.stiffness = std::clamp(wanted, before, 2 * before);
    if (compressed < 0) {
        contact.slack = depth_t0 - compressed * before / contact.stiffness;
        contact.stretch *= before / contact.stiffness;
    }
    contact.slack *= choice.keep;
}
//! [adapt_stiffness]

}  // namespace enduring
