#include "mended_friction.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <limits>

namespace enduring {
namespace {

constexpr int most_rounds = 30;
constexpr double small_change = 1e-3;  ///< of what a pair can hold: no impulse changes by more in the last round

/// A pair at work.
struct RubbingPair {
    Contact* contact;
    TangentPlane plane;
    double normal_impulse;
    double inverse_mass;  ///< of its share of both bodies [1/kg]
    Anchor anchor;
    Vec2 impulse = Vec2::Zero(), change = Vec2::Zero();
    Vec2 free_velocity = Vec2::Zero();  ///< slip with all normal impulses in effect, and no friction [m/s]
};

void try_on_bodies(const World& world, const Contact& contact, const Vec3& impulse)
{
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto v = static_cast<std::size_t>(i);
        body_of_vertex(world, contact, i).try_impulse(contact.vertices[v], contact.weights[v] * impulse);
    }
}

/// With everything in effect that was tried.
Vec2 slip_velocity(const World& world, const RubbingPair& pair)
{
    const Contact& contact = *pair.contact;
    Vec3 velocity = Vec3::Zero();
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto v = static_cast<std::size_t>(i);
        velocity += contact.weights[v] * body_of_vertex(world, contact, i).tried_velocity(contact.vertices[v]);
    }
    return pair.plane.of(velocity);
}

std::vector<RubbingPair> pushing_pairs(const World& world, Contacts& contacts, const FrictionParameters& friction, double dt)
{
    const MassShares shares(world, contacts);
    std::vector<RubbingPair> pairs;
    for (Contact& contact : contacts) {
        if (!pushes_now(contact))
            continue;
        const double normal_impulse = contact.impulse.norm();
        const TangentPlane plane(contact.impulse / normal_impulse);
        const double inverse_mass = shares.inverse_mass(world, contact, plane);
        if (inverse_mass > 0)  // else nothing here can move
            pairs.push_back({&contact, plane, normal_impulse, inverse_mass,
                             anchor_of(friction, inverse_mass, plane.of(contact.stretch), dt)});
    }
    return pairs;
}

Vec2 cut_to(double limit, const Vec2& impulse)
{
    const double length = impulse.norm();
    return length > limit ? Vec2(impulse * (limit / length)) : impulse;
}

/// What friction leaves of a stretch (see stretch_after_slip).
double longest_stretch(const RubbingPair& pair, double stretch, const FrictionParameters& friction, double dt)
{
    return pair.contact->slip > 0 ? stretch_after_slip(pair.contact->slip, pair.impulse.norm(), friction, dt) : stretch;
}

void try_normal_impulses(const World& world, std::vector<RubbingPair>& pairs)
{
    for (const std::unique_ptr<Body>& body : world.bodies)
        body->begin_trial();
    for (const RubbingPair& pair : pairs)
        try_on_bodies(world, *pair.contact, pair.contact->impulse);
    for (RubbingPair& pair : pairs)
        pair.free_velocity = slip_velocity(world, pair);
}

void try_springs(const World& world, std::vector<RubbingPair>& pairs, double mu_s, double dt)
{
    for (RubbingPair& pair : pairs) {
        pair.impulse = cut_to(mu_s * pair.normal_impulse, -dt * pair.anchor.spring * pair.anchor.stretch);
        try_on_bodies(world, *pair.contact, pair.plane.in_space(pair.impulse));
    }
}

/// One round: every pair answers what all of them did before. True if that changed little.
bool improve(const World& world, std::vector<RubbingPair>& pairs, const FrictionParameters& friction)
{
    bool settled = true;
    for (RubbingPair& pair : pairs) {
        const FrictionImpulse better = better_impulse(pair.impulse, slip_velocity(world, pair), pair.inverse_mass, pair.normal_impulse,
                                                      pair.anchor, friction);
        pair.change = better.impulse - pair.impulse;
        pair.contact->slip = better.slip;
        settled = settled && pair.change.norm() <= small_change * friction.mu_s * pair.normal_impulse;
    }
    for (RubbingPair& pair : pairs) {
        pair.impulse += pair.change;
        try_on_bodies(world, *pair.contact, pair.plane.in_space(pair.change));
    }
    return settled;
}

//! [take_no_energy]
/// The rounds end before they meet their fixed point, and where limits drop they may be far from it. So count: friction does
/// the work J.(v + u) / 2 between the slip v without it and u with it, and the springs change. Should energy have come out
/// of nothing, the multiple of all friction that takes most is what remains, and every anchor lets go.
void take_no_energy(const World& world, std::vector<RubbingPair>& pairs, const FrictionParameters& friction, double dt)
{
    double free_work = 0, own_work = 0, springs = 0;
    for (const RubbingPair& pair : pairs) {
        const Vec2 velocity = slip_velocity(world, pair);
        const Vec2 stretch = pair.anchor.stretch + dt * velocity;
        free_work += pair.impulse.dot(pair.free_velocity);
        own_work += pair.impulse.dot(velocity - pair.free_velocity);
        springs += 0.5 * pair.anchor.spring * (cut_to(longest_stretch(pair, stretch.norm(), friction, dt), stretch).squaredNorm()
                                               - pair.anchor.stretch.squaredNorm());
    }
    if (free_work + 0.5 * own_work + springs <= 0)
        return;
    const double best = own_work > 0 ? std::clamp(-free_work / own_work, 0.0, 1.0) : 0;
    for (RubbingPair& pair : pairs) {
        pair.impulse *= best;
        pair.contact->slip = std::numeric_limits<double>::infinity();
    }
}
//! [take_no_energy]

}  // namespace

Anchor anchor_of(const FrictionParameters& friction, double inverse_mass, const Vec2& stretch, double dt)
{
    const double spring = std::min(friction.spring, 1 / (dt * dt * inverse_mass));
    return {spring, 2 * friction.damping_ratio * std::sqrt(spring / inverse_mass), stretch, dt};
}

double stretch_after_slip(double slip, double impulse, const FrictionParameters& friction, double dt)
{
    return (1 - slip_weight(friction.weighting, slip)) * impulse / (dt * friction.spring);
}

//! [better_impulse]
FrictionImpulse better_impulse(const Vec2& impulse, const Vec2& velocity, double inverse_mass, double normal_impulse,
                               const Anchor& anchor, const FrictionParameters& friction)
{
    const double response = inverse_mass + anchor.yielding();
    const Vec2 wanted = impulse - (velocity - anchor.held_velocity(impulse)) / response;
    const double length = wanted.norm(), most = friction.mu_s * normal_impulse;
    if (length <= most)
        return {wanted, 0};
    const double slip = response * (length - most);  // of the anchor, when mu_s has done its best
    const double mu = friction.mu_s - (friction.mu_s - friction.mu_d) * slip_weight(friction.weighting, slip);
    return {wanted * (mu * normal_impulse / length), slip};
}
//! [better_impulse]

//! [rub_together]
void rub_together(const World& world, Contacts& contacts, const FrictionParameters& friction, double dt)
{
    std::vector<RubbingPair> pairs = pushing_pairs(world, contacts, friction, dt);
    try_normal_impulses(world, pairs);
    try_springs(world, pairs, friction.mu_s, dt);
    bool settled = false;
    for (int round = 0; round < most_rounds && !settled; ++round)
        settled = improve(world, pairs, friction);
    take_no_energy(world, pairs, friction, dt);
    for (const RubbingPair& pair : pairs)
        pair.contact->friction = pair.plane.in_space(cut_to(friction.mu_s * pair.normal_impulse, pair.impulse));
}
//! [rub_together]

}  // namespace enduring
