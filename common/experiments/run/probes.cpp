#include "common/experiments/run/probes.hpp"

#include "common/experiments/run/centre_of_mass.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/pressed_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enduring {

const Body& body_named(const World& world, std::string_view name)
{
    std::string known;
    for (const std::unique_ptr<Body>& body : world.bodies) {
        if (body->name() == name)
            return *body;
        known += (known.empty() ? "" : ", ") + body->name();
    }
    throw InputError("the scene has no body \"" + std::string(name) + "\"; it has " + known);
}

EnergyProbe::EnergyProbe() : TableProbe({"time_s", "kinetic_j", "gravitational_j", "elastic_j", "total_j"}) {}

void EnergyProbe::observe(const World& world, const Contacts&, double)
{
    const Energy sum = total_energy(world);
    table_.add({world.time, sum.kinetic, sum.gravitational, sum.elastic, sum.total()});
}

MomentumProbe::MomentumProbe()
    : TableProbe({"time_s", "px_kg_m_per_s", "py_kg_m_per_s", "pz_kg_m_per_s", "lx_kg_m2_per_s",
                  "ly_kg_m2_per_s", "lz_kg_m2_per_s"})
{}

void MomentumProbe::observe(const World& world, const Contacts&, double)
{
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
    for (const std::unique_ptr<Body>& body : world.bodies) {
        linear += body->linear_momentum();
        angular += body->angular_momentum(Vec3::Zero());
    }
    table_.add({world.time, linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()});
}

PenetrationProbe::PenetrationProbe(double stiffness)
    : TableProbe({"time_s", "pairs", "pairs_inside", "depth_sum_m", "depth_max_m", "nk_n_per_m",
                  "stable_step_s", "dt_s", "plane_depth_m"}),
      stiffness_(stiffness)
{}

void PenetrationProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    double sum = 0, deepest = 0, in_plane = 0;
    long inside = 0;
    for (const Contact& contact : contacts) {
        const double depth = -contact_geometry(world, contact, 1).depth;
        if (depth <= 0 || !contact.is_spring())
            continue;
        sum += depth;
        deepest = std::max(deepest, depth);
        if (contact.on_plane())
            in_plane = std::max(in_plane, depth);
        ++inside;
    }
    double stiffest = 0, shortest = std::numeric_limits<double>::infinity();
    const std::vector<PressedBodies> pressed = pressed_bodies(world, contacts, stiffness_);
    for (const PressedBodies& bodies : pressed) {
        stiffest = std::max(stiffest, bodies.stiffness);
        shortest = std::min(shortest, stable_step(world, bodies, PenaltyMethod::continuous));
    }
    table_.add({world.time, static_cast<long>(contacts.size()), inside, sum, deepest, stiffest,
                pressed.empty() ? 0 : shortest, dt, in_plane});
}

ForceProbe::ForceProbe(std::string on, std::string from)
    : TableProbe({"time_s", "fx_n", "fy_n", "fz_n", "pairs"}), on_(std::move(on)), from_(std::move(from))
{}

void ForceProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    body_named(world, on_);
    const bool plane = std::any_of(world.planes.begin(), world.planes.end(),
                                   [&](const Plane& p) { return p.name == from_; });
    if (!plane)
        body_named(world, from_);

    Vec3 impulse = Vec3::Zero();
    long pairs = 0;
    for (const Contact& contact : contacts) {
        const std::string &a = name_of_a(world, contact), &b = name_of_b(world, contact);
        const double sign = a == on_ && b == from_ ? 1 : a == from_ && b == on_ ? -1 : 0;
        impulse += sign * (contact.impulse + contact.friction);
        pairs += sign != 0;
    }
    const Vec3 force = impulse / last_part(world, dt);
    table_.add({world.time, force.x(), force.y(), force.z(), pairs});
}

MotionProbe::MotionProbe(std::string body)
    : TableProbe({"time_s", "x_m", "y_m", "z_m", "vx_m_per_s", "vy_m_per_s", "vz_m_per_s"}),
      body_(std::move(body))
{}

void MotionProbe::observe(const World& world, const Contacts&, double)
{
    const Body& body = body_named(world, body_);
    const Vec3 middle = centre_of_mass(body), velocity = body.mean_velocity();
    table_.add({world.time, middle.x(), middle.y(), middle.z(), velocity.x(), velocity.y(), velocity.z()});
}

}  // namespace enduring
