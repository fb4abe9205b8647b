#include "common/experiments/run/spring_ledger.hpp"

#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

std::vector<std::vector<Vec3>> positions_of(const World& world)
{
    std::vector<std::vector<Vec3>> positions;
    for (const auto& body : world.bodies)
        positions.emplace_back(body->positions_t0().begin(), body->positions_t0().end());
    return positions;
}

}  // namespace

SpringLedger::SpringLedger(const World& world, double stiffness,
                           std::optional<double> max_depenetration_velocity)
    : stiffness_(stiffness), max_depenetration_velocity_(max_depenetration_velocity),
      positions_(positions_of(world)), ended_badly_(world.ended_badly)
{}

double SpringLedger::held() const
{
    double sum = 0;
    for (const auto& [key, spring] : springs_)
        sum += spring.energy;
    return sum;
}

/// What a pair's spring does in the step, and what its impulses do.
SpringLedger::Booked SpringLedger::book(const World& world, const Contact& contact, bool ended_badly,
                                        double dt)
{
    const ContactGeometry end = contact_geometry(world, contact, 1);
    Vec3 way = Vec3::Zero();  // of p against q
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto n = static_cast<std::size_t>(i);
        const auto vertex = static_cast<std::size_t>(contact.vertices[n]);
        const std::size_t body = body_index(contact, i);
        way += contact.weights[n] * (world.bodies[body]->positions_t0()[vertex] - positions_[body][vertex]);
    }
    const double k = contact.spring.stiffness > 0 ? contact.spring.stiffness
                                                  : pair_stiffness(world, contact, stiffness_);
    const auto spring_at = [&](double depth) {
        const double compression = std::min(0.0, depth - contact.spring.rest_offset);
        return Spring{compression, k * compression * compression / 2, k};
    };
    Spring spring = spring_at(end.depth);
    if (ended_badly && contact.spring.stiffness > 0)
        spring.energy = std::min(spring.energy, contact.spring.load * contact.spring.load / (2 * k));
    const double pushed = contact.impulse.dot(way) / dt;
    accounts_.pushed += pushed;
    accounts_.rubbed += contact.friction.dot(way) / dt;
    accounts_.damped -= pushed + spring.energy;
    if (contact.resolved)
        accounts_.died += std::exchange(spring.energy, 0);
    return {{contact.kind, contact.body_a, contact.feature_a, contact.body_b, contact.feature_b},
            spring,
            spring_at(end.depth - end.normal.dot(way)),
            contact.impulse.norm() / dt,
            max_depenetration_velocity(world, contact, max_depenetration_velocity_, dt)};
}

//! [take_over]
void SpringLedger::take_over(Booked& booked, std::multimap<Key, Spring>::iterator before, double dt)
{
    constexpr double rounding = 1e-9;
    // Made stiffer without a jump of its force, a spring is less compressed and holds less. No body has
    // moved.
    const double softer = std::min(1.0, before->second.stiffness / booked.spring.stiffness);
    const double way = softer * before->second.compression - booked.at_start.compression;
    const bool slowly = way <= (1 + rounding) * booked.max_depenetration_velocity * dt;
    const double added_energy = slowly ? booked.force * way
                                       : booked.at_start.energy - softer * before->second.energy;
    (slowly ? accounts_.lifted : accounts_.jumped) += added_energy;
    booked.came = before->second.energy + added_energy;
    booked.known = true;
    springs_.erase(before);
}
//! [take_over]

/// A spring of the same vertex and the same bodies that nobody has taken over.
std::multimap<SpringLedger::Key, SpringLedger::Spring>::iterator SpringLedger::find_at_any_face(Key key)
{
    std::get<4>(key) = -1;
    const auto found = springs_.lower_bound(key);
    if (std::get<0>(key) != ContactKind::vertex_face || found == springs_.end())
        return springs_.end();
    std::get<4>(key) = std::get<4>(found->first);
    return key == found->first ? found : springs_.end();
}

void SpringLedger::add_step(const World& world, const Contacts& contacts, double dt)
{
    std::vector<Booked> all;
    const bool ended_badly = world.ended_badly > std::exchange(ended_badly_, world.ended_badly);
    for (const Contact& contact : contacts)
        if (!contact.held() && !contact.waiting())  // what waits has not begun
            all.push_back(book(world, contact, ended_badly, dt));
    for (Booked& booked : all)
        if (const auto before = springs_.find(booked.key); before != springs_.end())
            take_over(booked, before, dt);
    for (Booked& booked : all)
        if (const auto before = booked.known ? springs_.end() : find_at_any_face(booked.key);
            before != springs_.end())
            take_over(booked, before, dt);
    for (const auto& [key, spring] : springs_)
        accounts_.died += spring.energy;
    springs_.clear();
    for (Booked& booked : all) {
        if (!booked.known)
            accounts_.born += booked.came = booked.at_start.energy;
        accounts_.damped += booked.came;
        springs_.emplace(booked.key, booked.spring);
    }
    positions_ = positions_of(world);
}

}  // namespace enduring
