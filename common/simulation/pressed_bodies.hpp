#pragma once

#include "common/simulation/contact.hpp"
#include "common/simulation/contact_parameters.hpp"

#include <string>
#include <vector>

namespace enduring {

struct World;

/// Two bodies, or a body and a plane, and the springs of their pairs that lie
/// inside each other: side by side, they are one.
struct PressedBodies {
    int a = -1, b = -1;  ///< indices into World::bodies; for a plane b indexes World::planes
    bool with_plane = false;
    long pairs = 0;        ///< n
    double stiffness = 0;  ///< n k [N/m]
    double energy = 0;     ///< k depth^2 / 2, summed [J]
};

/// Those that press each other at the end of a step, in the order of the list. A held pair is no spring.
/// @param stiffness  k of one pair [N/m]; that of a plane with its own is read from the plane
std::vector<PressedBodies> pressed_bodies(const World& world, const Contacts& contacts, double stiffness);

/// Those that pushed each other in the step just done, though its impulses may have parted them: the springs
/// that the limit on the step is about. No energy is counted.
std::vector<PressedBodies> pushed_bodies(const World& world, const Contacts& contacts, double stiffness);

/// "'cube' and 'ground'"
std::string names_of(const World& world, const PressedBodies& pressed);

/// What h = n k dt^2 / m has to stay below for a contact to be stable: 4 / (1 + 2a),
/// where a is the place in the step at which the depth is found; 1 for discrete and
/// 1/2 for continuous forces.
constexpr double largest_stable_h(PenaltyMethod method)
{
    return method == PenaltyMethod::discrete ? 4.0 / 3.0 : 2.0;
}

/// The longest stable step of one spring between two bodies that move as wholes [s].
/// @param inverse_mass  of both together, 1/m_a + 1/m_b [1/kg]
/// @param stiffness     n k [N/m]
double stable_step(double inverse_mass, double stiffness, PenaltyMethod method);
double stable_step(const World& world, const PressedBodies& pressed, PenaltyMethod method);

}  // namespace enduring
