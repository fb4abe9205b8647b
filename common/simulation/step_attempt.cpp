#include "common/simulation/step_attempt.hpp"

#include "common/simulation/body_pose.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enduring {

SavedState::SavedState(World& world, const Contacts& contacts)
    : contacts_(contacts), joints_(world.joints), time_(world.time), driven_(world.driven)
{
    bodies_.reserve(world.bodies.size());
    for (const auto& body : world.bodies)
        bodies_.push_back(state_of(*body));
}

void SavedState::restore(World& world, Contacts& contacts) const
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        restore_state(*world.bodies[i], bodies_[i]);
    contacts = contacts_;
    world.joints = joints_;
    world.time = time_;
    world.driven = driven_;
}

//! [held_energy]
HeldEnergy held_energy(const World& world, const Contacts& contacts)
{
    const Energy energy = total_energy(world);
    const double springs = spring_energy(contacts);
    return {energy.total() + springs, energy.kinetic + springs, springs};
}

namespace {

/// What bodies that move as given do through a pair by their turns [J].
double turning_work(const World& world, const Contact& contact, double dt)
{
    const auto turn = [&](int number) -> Vec3 {
        const Body& body = *world.bodies[static_cast<std::size_t>(number)];
        return body.is_static() ? mean_turn_rate(body, dt) : Vec3(Vec3::Zero());
    };
    const bool on_plane = contact.on_plane();
    return contact.turning.dot((on_plane ? Vec3(Vec3::Zero()) : turn(contact.body_b)) - turn(contact.body_a));
}

}  // namespace

double driven_work(const World& world, const Contacts& contacts, double dt)
{
    double work = 0;
    for (const auto& body : world.bodies)
        work += body->driven_work(dt);
    for (const OutsideImpulse& push : world.attempt.from_outside) {
        const Body& body = *world.bodies[push.body];
        const auto vertex = static_cast<std::size_t>(push.vertex);
        work += push.impulse.dot(body.positions_t1()[vertex] - body.positions_t0()[vertex]) / dt;
    }
    const bool any_stands = std::any_of(world.bodies.begin(), world.bodies.end(),
                                        [](const auto& body) { return body->is_static(); });
    for (const Contact& contact : contacts)
        if (any_stands && contact.answered() && !contact.turning.isZero(0))
            work += turning_work(world, contact, dt);
    for (const Contact& contact : contacts)
        for (int i = 0; any_stands && contact.answered() && i < contact.vertex_count(); ++i) {
            const Body& body = *world.bodies[body_index(contact, i)];
            const auto n = static_cast<std::size_t>(i);
            const auto vertex = static_cast<std::size_t>(contact.vertices[n]);
            if (body.is_static())
                work -= contact.weights[n] *
                        (contact.impulse + contact.friction)
                            .dot(body.positions_t1()[vertex] - body.positions_t0()[vertex]) /
                        dt;
            if (contact.spring.stiffness > 0)  // of a solver that reads how surfaces run
                work -= contact.weights[n] * contact.friction.dot(body.surface_velocity());
        }
    return work;
}

double turned_lever_work(const World& world, double dt)
{
    double work = 0;
    for (const auto& body : world.bodies)
        work += body->turned_lever_work(world.gravity, dt);
    return work;
}

bool has_gained(const World& world, const HeldEnergy& before, const HeldEnergy& after, double dt)
{
    const double fall = dt * world.gravity.norm();
    double at_rest = 0;
    for (const auto& body : world.bodies) {
        const double trembling = scale_parts.trembling * body->size() / dt;
        at_rest += body->mass() * (attempt_limits.gain_at_rest * fall * fall + trembling * trembling);
    }
    const double gain = after.total - before.total - world.attempt.added_energy;
    return !(gain <= attempt_limits.gain * (before.moving + std::abs(world.attempt.added_energy)) + at_rest +
                         attempt_limits.rounding * std::abs(before.total));
}
//! [held_energy]

}  // namespace enduring
