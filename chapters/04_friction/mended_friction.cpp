#include "mended_friction.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

constexpr int most_rounds = 30;
constexpr double settled = 1e-3;  ///< of what a pair can hold: no impulse changes by more in the last round

/// A pair at work.
struct RubbingPair {
    Contact* contact;
    TangentPlane plane;
    double normal_impulse;
    SharedInverseMass share;
    Anchor anchor;
    Vec2 impulse = Vec2::Zero();
};

void try_on_bodies(const World& world, const Contact& contact, const Vec3& impulse)
{
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto v = static_cast<std::size_t>(i);
        body_of_vertex(world, contact, i).try_impulse(contact.vertices[v], contact.weights[v] * impulse);
    }
}

/// With everything in effect that was tried. Bodies without trials answer as the pair's share of them would alone.
Vec2 slip_velocity(const World& world, const RubbingPair& pair)
{
    const Contact& contact = *pair.contact;
    Vec3 velocity = Vec3::Zero();
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto v = static_cast<std::size_t>(i);
        velocity += contact.weights[v] * body_of_vertex(world, contact, i).tried_velocity(contact.vertices[v]);
    }
    return pair.plane.of(velocity) + pair.share.untried * pair.impulse;
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
        const SharedInverseMass share = shares.inverse_mass(world, contact, plane);
        if (share.all > 0)  // else nothing here can move
            pairs.push_back({&contact, plane, normal_impulse, share,
                             anchor_of(friction, share.all, plane.of(contact.stretch), dt)});
    }
    return pairs;
}

Vec2 cut_to(double limit, const Vec2& impulse)
{
    const double length = impulse.norm();
    return length > limit ? Vec2(impulse * (limit / length)) : impulse;
}

}  // namespace

Anchor anchor_of(const FrictionParameters& friction, double inverse_mass, const Vec2& stretch, double dt)
{
    const double spring = std::min(friction.spring, 1 / (dt * dt * inverse_mass));
    return {spring, 2 * friction.damping_ratio * std::sqrt(spring / inverse_mass), stretch, dt};
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
    for (const std::unique_ptr<Body>& body : world.bodies)
        body->begin_trial();
    for (RubbingPair& pair : pairs) {
        pair.impulse = cut_to(friction.mu_s * pair.normal_impulse, -dt * pair.anchor.spring * pair.anchor.stretch);
        try_on_bodies(world, *pair.contact, pair.contact->impulse + pair.plane.in_space(pair.impulse));
    }

    std::vector<Vec2> changes(pairs.size());
    bool all_settled = false;
    for (int round = 0; round < most_rounds && !all_settled; ++round) {
        all_settled = true;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            RubbingPair& pair = pairs[i];
            const FrictionImpulse better = better_impulse(pair.impulse, slip_velocity(world, pair), pair.share.all,
                                                          pair.normal_impulse, pair.anchor, friction);
            changes[i] = better.impulse - pair.impulse;
            pair.contact->slip = better.slip;
            all_settled = all_settled && changes[i].norm() <= settled * friction.mu_s * pair.normal_impulse;
        }
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            pairs[i].impulse += changes[i];
            try_on_bodies(world, *pairs[i].contact, pairs[i].plane.in_space(changes[i]));
        }
    }
    for (const RubbingPair& pair : pairs)
        pair.contact->friction = pair.plane.in_space(cut_to(friction.mu_s * pair.normal_impulse, pair.impulse));
}
//! [rub_together]

}  // namespace enduring
