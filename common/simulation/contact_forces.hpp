#pragma once

#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"

#include <vector>

namespace enduring {

/// Pairs tell impulses. What a reader of forces divides them by, and where the forces act, is said here once.

/// The time in which the pairs gave the impulses that they tell [s]: dt, but after a step that was taken in
/// halves its last part, dt / 2^n. For a world as advance() leaves it.
/// @param dt  of the whole step [s], positive
double last_part(const World& world, double dt);

/// What a pair exerts on its body A, and the opposite on B: the mean over the last part of the step [N].
struct PairForce {
    Vec3 normal = Vec3::Zero();    ///< out of B
    Vec3 friction = Vec3::Zero();  ///< along the surface
    Vec3 total() const { return normal + friction; }
};

/// @param part  last_part() of the step
inline PairForce pair_force(const Contact& contact, double part)
{
    return {contact.impulse / part, contact.friction / part};
}

/// For each body, by its place in World::bodies, the force of all pairs on each of its surface vertices [N].
std::vector<std::vector<Vec3>> vertex_forces(const World& world, const Contacts& contacts, double dt);

/// For each body the sum of those [N]. Between two bodies forces cancel; planes take what is left.
std::vector<Vec3> body_forces(const World& world, const Contacts& contacts, double dt);

}  // namespace enduring
