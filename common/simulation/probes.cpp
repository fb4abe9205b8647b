#include "common/simulation/probes.hpp"

#include "common/report/input_error.hpp"
#include "common/simulation/contact_geometry.hpp"

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
    Energy sum;
    for (const std::unique_ptr<Body>& body : world.bodies) {
        const Energy energy = body->energy(world.gravity);
        sum.kinetic += energy.kinetic;
        sum.gravitational += energy.gravitational;
        sum.elastic += energy.elastic;
    }
    table_.add({world.time, sum.kinetic, sum.gravitational, sum.elastic, sum.total()});
}

MomentumProbe::MomentumProbe()
    : TableProbe({"time_s", "px_kg_m_per_s", "py_kg_m_per_s", "pz_kg_m_per_s", "lx_kg_m2_per_s", "ly_kg_m2_per_s", "lz_kg_m2_per_s"})
{
}

void MomentumProbe::observe(const World& world, const Contacts&, double)
{
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
    for (const std::unique_ptr<Body>& body : world.bodies) {
        linear += body->linear_momentum();
        angular += body->angular_momentum(Vec3::Zero());
    }
    table_.add({world.time, linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()});
}

namespace {

/// The pairs that two bodies (or a body and a plane) have inside each other.
struct BodyPair {
    int a, b;
    bool with_plane;
    double stiffness = 0;  ///< n k [N/m]
};

BodyPair& pair_of(std::vector<BodyPair>& pairs, const Contact& contact)
{
    const bool with_plane = contact.kind == ContactKind::vertex_plane;
    int a = contact.body_a, b = contact.body_b;
    if (!with_plane && b < a)
        std::swap(a, b);
    const auto known = std::find_if(pairs.begin(), pairs.end(),
                                    [&](const BodyPair& pair) { return pair.a == a && pair.b == b && pair.with_plane == with_plane; });
    return known != pairs.end() ? *known : pairs.emplace_back(BodyPair{a, b, with_plane});
}

double inverse_mass(const World& world, int body)
{
    const double mass = world.bodies[static_cast<std::size_t>(body)]->mass();
    return mass > 0 ? 1 / mass : 0;
}

double stable_step(const World& world, const BodyPair& pair)
{
    const double inverse = inverse_mass(world, pair.a) + (pair.with_plane ? 0 : inverse_mass(world, pair.b));
    return std::sqrt(2 / (inverse * pair.stiffness));
}

}  // namespace

PenetrationProbe::PenetrationProbe(double stiffness)
    : TableProbe({"time_s", "pairs", "pairs_inside", "depth_sum_m", "depth_max_m", "nk_n_per_m", "stable_step_s", "dt_s", "plane_depth_m"}),
      stiffness_(stiffness)
{
}

void PenetrationProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    std::vector<BodyPair> pairs;
    double sum = 0, deepest = 0, in_plane = 0;
    long inside = 0;
    for (const Contact& contact : contacts) {
        const double depth = -contact_geometry(world, contact, 1).depth;
        if (depth <= 0 || contact.held)
            continue;
        sum += depth;
        deepest = std::max(deepest, depth);
        if (contact.kind == ContactKind::vertex_plane)
            in_plane = std::max(in_plane, depth);
        ++inside;
        pair_of(pairs, contact).stiffness += pair_stiffness(world, contact, stiffness_);
    }
    double stiffest = 0, shortest = std::numeric_limits<double>::infinity();
    for (const BodyPair& pair : pairs) {
        stiffest = std::max(stiffest, pair.stiffness);
        shortest = std::min(shortest, stable_step(world, pair));
    }
    table_.add({world.time, static_cast<long>(contacts.size()), inside, sum, deepest, stiffest, pairs.empty() ? 0 : shortest, dt, in_plane});
}

ForceProbe::ForceProbe(std::string on, std::string from)
    : TableProbe({"time_s", "fx_n", "fy_n", "fz_n", "pairs"}), on_(std::move(on)), from_(std::move(from))
{
}

void ForceProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    body_named(world, on_);
    const bool plane = std::any_of(world.planes.begin(), world.planes.end(), [&](const Plane& p) { return p.name == from_; });
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
    const Vec3 force = impulse / dt;
    table_.add({world.time, force.x(), force.y(), force.z(), pairs});
}

MotionProbe::MotionProbe(std::string body)
    : TableProbe({"time_s", "x_m", "y_m", "z_m", "vx_m_per_s", "vy_m_per_s", "vz_m_per_s"}), body_(std::move(body))
{
}

void MotionProbe::observe(const World& world, const Contacts&, double)
{
    const Body& body = body_named(world, body_);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& vertex : body.positions_t0())
        middle += vertex;
    middle /= static_cast<double>(std::max<std::size_t>(1, body.positions_t0().size()));
    const Vec3 velocity = body.mass() > 0 ? Vec3(body.linear_momentum() / body.mass()) : Vec3(Vec3::Zero());
    table_.add({world.time, middle.x(), middle.y(), middle.z(), velocity.x(), velocity.y(), velocity.z()});
}

InversionProbe::InversionProbe() : TableProbe({"time_s", "inverted_elements"}) {}

void InversionProbe::observe(const World& world, const Contacts&, double)
{
    long inverted = 0;
    for (const std::unique_ptr<Body>& body : world.bodies)
        inverted += body->inverted_elements();
    table_.add({world.time, inverted});
}

}  // namespace enduring
