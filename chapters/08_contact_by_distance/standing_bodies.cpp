#include "chapters/08_contact_by_distance/standing_bodies.hpp"

#include "chapters/07_implicit_contact/joined_sets.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/whole_motion.hpp"

#include <Eigen/Cholesky>

namespace enduring {
namespace {

/// One of the bodies that move on as one.
struct Member {
    Body* body;
    WholeMotion stood;    ///< when the part began
    Vec3 momentum, spin;  ///< of the answer [kg m/s]; about its own centre [kg m^2/s]
};

//! [move_as_one]
void move_as_one(const std::vector<Member>& members)
{
    double mass = 0;
    Vec3 centre = Vec3::Zero(), momentum = Vec3::Zero();
    for (const Member& member : members) {
        mass += member.stood.mass;
        centre += member.stood.mass * member.stood.centre;
        momentum += member.momentum;
    }
    centre /= mass;

    Vec3 spin = Vec3::Zero();
    Mat3 inertia = Mat3::Zero();
    for (const Member& member : members) {
        const Vec3 lever = member.stood.centre - centre;
        spin += member.spin + lever.cross(member.momentum);
        inertia += member.stood.inertia +
                   member.stood.mass * (lever.squaredNorm() * Mat3::Identity() - lever * lever.transpose());
    }
    const Vec3 turn = inertia.llt().solve(spin);
    for (const Member& member : members)
        move_as_a_whole(*member.body, momentum / mass + turn.cross(member.stood.centre - centre), turn);
}
//! [move_as_one]

}  // namespace

bool StandingBodies::add(World& world, int a, int b)
{
    belong_together_.emplace_back(a, b);
    const bool a_is_new = stand(world, a);
    return stand(world, b) || a_is_new;
}

bool StandingBodies::stand(World& world, int index)
{
    if (index < 0 || world.bodies[static_cast<std::size_t>(index)]->is_static() || states_.count(index) > 0)
        return false;
    Body& body = *world.bodies[static_cast<std::size_t>(index)];
    states_[index] = state_of(body);
    body.stand_still();
    for (const Joint& joint : world.joints)
        if (!joint.broken && (joint.a.body == index || joint.b.body == index)) {
            belong_together_.emplace_back(joint.a.body, joint.b.body);
            stand(world, joint.a.body == index ? joint.b.body : joint.a.body);
        }
    return true;
}

void StandingBodies::move_on(World& world)
{
    const auto is_free = [&](int body) {
        return body >= 0 && whole_motion(*world.bodies[static_cast<std::size_t>(body)]).has_value();
    };
    const int fixed = static_cast<int>(world.bodies.size());  // all that is held or given counts as one body
    JoinedSets sets(world.bodies.size() + 1);
    for (const auto& [a, b] : belong_together_)
        sets.join(is_free(a) ? a : fixed, is_free(b) ? b : fixed);

    std::map<int, std::vector<Member>> groups;
    for (const auto& [index, state] : states_) {
        Body& body = *world.bodies[static_cast<std::size_t>(index)];
        const std::optional<WholeMotion> answer = whole_motion(body);
        restore_state(body, state);
        if (answer && sets.least_of(index) != sets.least_of(fixed))
            groups[sets.least_of(index)].push_back(
                {&body, whole_motion(body).value(), answer->momentum, answer->spin});
        else if (auto* const rigid = dynamic_cast<RigidBody*>(&body))
            rigid->move_with(Vec3::Zero(), Vec3::Zero());
    }
    for (const auto& [least, members] : groups)
        move_as_one(members);
    clear();
}

void StandingBodies::clear()
{
    states_.clear();
    belong_together_.clear();
}

}  // namespace enduring
