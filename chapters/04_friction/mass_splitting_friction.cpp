#include "chapters/04_friction/mass_splitting_friction.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

constexpr int max_rounds = 30;
constexpr double small_change = 1e-3;  ///< of what the pairs can hold

/// A pair at work.
struct FrictionPair {
    Contact* contact;
    TangentPlane plane;
    double normal_impulse;
    double inverse_mass;  ///< of its share of both bodies [1/kg]
    Anchor anchor;
    Vec2 impulse = Vec2::Zero(), change = Vec2::Zero();
    double limit = 0;  ///< of the impulse's length, where the pair slips [N s]
};

/// Impulses on pairs, tried out on all bodies together.
class Trials {
public:
    explicit Trials(const World& world)
    {
        for (const std::unique_ptr<Body>& body : world.bodies)
            bodies_.push_back(body->begin_trial());
    }

    void push(const Contact& contact, const Vec3& impulse)
    {
        for (int i = 0; i < contact.vertex_count(); ++i) {
            const auto v = static_cast<std::size_t>(i);
            bodies_[body_index(contact, i)]->push(contact.vertices[v], contact.weights[v] * impulse);
        }
    }

    /// Of p against q [m/s].
    Vec3 velocity(const Contact& contact)
    {
        Vec3 velocity = Vec3::Zero();
        for (int i = 0; i < contact.vertex_count(); ++i) {
            const auto v = static_cast<std::size_t>(i);
            velocity += contact.weights[v] * bodies_[body_index(contact, i)]->velocity(contact.vertices[v]);
        }
        return velocity;
    }

private:
    std::vector<std::unique_ptr<Trial>> bodies_;
};

std::vector<FrictionPair> friction_pairs(const World& world, Contacts& contacts,
                                         const MassSplitting& friction, double dt)
{
    MassShares shares(world, contacts);
    std::vector<FrictionPair> pairs;
    for (Contact& contact : contacts) {
        if (!pushes_now(contact))
            continue;
        const double normal_impulse = contact.impulse.norm();
        const TangentPlane plane(contact.impulse / normal_impulse);
        const double inverse_mass = shares.inverse_mass(world, contact, plane);
        if (inverse_mass > 0)  // else nothing here can move
            pairs.push_back({&contact, plane, normal_impulse, inverse_mass,
                             anchor_of(friction, inverse_mass, plane.of(contact.spring.stretch), dt)});
    }
    return pairs;
}

Vec2 cut_to(double limit, const Vec2& impulse)
{
    const double length = impulse.norm();
    return length > limit ? Vec2(impulse * (limit / length)) : impulse;
}

void try_normal_impulses(Trials& trials, const std::vector<FrictionPair>& pairs)
{
    for (const FrictionPair& pair : pairs)
        trials.push(*pair.contact, pair.contact->impulse);
}

void try_springs(Trials& trials, std::vector<FrictionPair>& pairs, double mu_s, double dt)
{
    for (FrictionPair& pair : pairs) {
        pair.limit = mu_s * pair.normal_impulse;
        pair.impulse = cut_to(mu_s * pair.normal_impulse, -dt * pair.anchor.spring * pair.anchor.stretch);
        trials.push(*pair.contact, pair.plane.in_space(pair.impulse));
    }
}

//! [toward]
/// A pair's limit goes half of its way in each round: limits that fall all at once come back in the next.
Vec2 toward(const FrictionImpulse& better, double mu_s, FrictionPair& pair)
{
    const double limit = better.slip > 0 ? better.impulse.norm() : mu_s * pair.normal_impulse;
    pair.limit = 0.5 * (pair.limit + limit);
    return better.slip > 0 && limit > 0 ? Vec2(better.impulse * (pair.limit / limit)) : better.impulse;
}
//! [toward]

/// One round: every pair answers what all of them did before.
/// @return  how much that changed, relative to what the pairs can hold, as root mean squares
double improve(Trials& trials, std::vector<FrictionPair>& pairs, const MassSplitting& friction)
{
    double change = 0, most = 0;
    for (FrictionPair& pair : pairs) {
        const FrictionImpulse better = better_impulse(
            pair.impulse, pair.plane.of(trials.velocity(*pair.contact)), pair.inverse_mass,
            pair.normal_impulse, pair.anchor, friction);
        pair.change = toward(better, friction.mu_s, pair) - pair.impulse;
        pair.contact->spring.slip = better.slip;
        change += pair.change.squaredNorm();
        most += std::pow(friction.mu_s * pair.normal_impulse, 2);
    }
    for (FrictionPair& pair : pairs) {
        pair.impulse += pair.change;
        trials.push(*pair.contact, pair.plane.in_space(pair.change));
    }
    return change > 0 ? std::sqrt(change / most) : 0;
}

/// Until little changes, or until it does not get less: among hundreds of
/// pairs there is always one that is just letting go.
bool worth_another(const std::vector<double>& changes)
{
    const std::size_t rounds = changes.size();
    const bool stalls = rounds > 10 && changes.back() > 0.8 * changes[rounds - 5];
    return changes.back() > small_change && !stalls && rounds < max_rounds;
}

}  // namespace

//! [mass_splitting_friction]
void mass_splitting_friction(const World& world, Contacts& contacts, const MassSplitting& friction, double dt)
{
    std::vector<FrictionPair> pairs = friction_pairs(world, contacts, friction, dt);
    Trials trials(world);
    try_normal_impulses(trials, pairs);
    try_springs(trials, pairs, friction.mu_s, dt);
    std::vector<double> changes;
    do
        changes.push_back(improve(trials, pairs, friction));
    while (worth_another(changes));
    for (const FrictionPair& pair : pairs)
        pair.contact->friction =
            pair.plane.in_space(cut_to(friction.mu_s * pair.normal_impulse, pair.impulse));
}
//! [mass_splitting_friction]

}  // namespace enduring
