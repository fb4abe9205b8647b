#include "chapters/07_implicit_contact/restitution.hpp"

#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

using Eigen::MatrixXd;
using Eigen::VectorXd;

//! [touching_speed]
double touching_speed(const PairImpact& impact)
{
    const double a = impact.acceleration, at_start = impact.free_speed - a * impact.dt + a * impact.dt / 2;
    const double squared = at_start * at_start - 2 * a * impact.gap_t0;
    return impact.free_speed < 0 && squared > 0 ? -std::sqrt(squared) : 0;
}

double speed_after(const PairImpact& impact, double leaving)
{
    const double a = impact.acceleration;
    return std::sqrt(std::max(0.0, leaving * leaving - 2 * a * impact.pressed)) - a * impact.dt / 2;
}
//! [touching_speed]

void ImpulseWork::add(const PushedPair& pair, const Vec3& impulse, const Vec3& friction)
{
    const double against_running = friction.dot(pair.running);
    slope += impulse.dot(pair.velocity) + against_running;
    fall += impulse.dot(pair.acceleration);
    driven -= impulse.dot(pair.velocity_driven) + against_running;
}

namespace {

/// Whether a pair carried an impulse, and not what rounding leaves of none.
bool has_pushed(const World& world, const Contact& contact, double dt)
{
    return contact.answered() && contact.is_spring() && contact.spring.stiffness > 0 &&
           contact.impulse.norm() > contact.spring.stiffness * dt * restitution_limits.least_length *
                                        natural_length(world, contact);
}

PushedPair pushed_pair(const World& world, const Contact& contact, const FrictionCoefficients& friction,
                       double dt)
{
    PushedPair one;
    one.normal = contact.impulse.normalized();
    one.running = running_of_surfaces(world, contact);
    one.restitution = pair_restitution(world, contact);
    one.mu = pair_friction(world, contact, friction).mu_d;
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const Body& body = body_of_vertex(world, contact, i);
        const auto vertex = static_cast<std::size_t>(i);
        const double weight = contact.weights[vertex];
        const Vec3 velocity = weight * body.velocity(contact.vertices[vertex]);
        one.velocity += velocity;
        one.acceleration += weight * body.acceleration(contact.vertices[vertex], world.gravity);
        if (body.is_static())
            one.velocity_driven += velocity;
    }
    one.impact.dt = dt;
    one.impact.acceleration = one.normal.dot(one.acceleration);
    one.impact.pressed = std::max(0.0, -contact_geometry(world, contact, 1).depth);
    one.impact.gap_t0 = std::max(0.0, -one.impact.pressed - dt * one.normal.dot(one.velocity));
    return one;
}

MatrixXd response_of(const IslandImpact& island)
{
    const auto pairs = static_cast<Eigen::Index>(island.pairs.size());
    MatrixXd along(island.step.problem.size, pairs), answers(island.step.problem.size, pairs);
    for (Eigen::Index i = 0; i < pairs; ++i) {
        const auto row = static_cast<std::size_t>(i);
        VectorXd unit = VectorXd::Zero(island.step.problem.size);
        island.step.problem.rows[row].add_impulse(island.pairs[row].normal, unit);
        along.col(i) = unit;
        answers.col(i) = times_response(island.step.problem, unit);
    }
    return along.transpose() * answers;
}

}  // namespace

Island pushed_part(const World& world, const Island& island, double dt)
{
    Island part;
    bool any_meets = false;
    for (Contact* const contact : island.contacts) {
        if (!has_pushed(world, *contact, dt))
            continue;
        part.contacts.push_back(contact);
        for (int i = 0; i < contact->vertex_count(); ++i)
            if (!body_of_vertex(world, *contact, i).is_static())
                part.bodies.push_back(static_cast<int>(body_index(*contact, i)));
        any_meets = any_meets || (pair_restitution(world, *contact) > 0 && contact->began_open);
    }
    if (!any_meets)
        return {};
    std::sort(part.bodies.begin(), part.bodies.end());
    part.bodies.erase(std::unique(part.bodies.begin(), part.bodies.end()), part.bodies.end());
    return part;
}

IslandImpact impact_of(const World& world, const Island& part, const FrictionCoefficients& friction,
                       double dt)
{
    IslandImpact island;
    island.step = set_up(world, part, {}, friction, {0, dt}, false);
    const StepProblem& step = island.step;
    for (const Contact* contact : step.of_row) {
        island.pairs.push_back(pushed_pair(world, *contact, friction, dt));
        island.work.add(island.pairs.back(), contact->impulse + contact->friction, contact->friction);
    }
    // The impulses acted with the levers of the free end: on a body that spins, those behind the commit would
    // tell another energy.
    const StepProblem acted = set_up(world, part, {}, friction, {1, dt}, false);
    const VectorXd momentum = momentum_of(acted),
                   halfway = velocities_of(world, acted) - times_response(acted.problem, momentum) / 2;
    island.lost = island.work.driven - momentum.dot(halfway);
    const VectorXd change = times_response(step.problem, momentum);
    for (std::size_t i = 0; i < island.pairs.size(); ++i) {
        PushedPair& pair = island.pairs[i];
        pair.impact.free_speed = pair.normal.dot(pair.velocity - step.problem.rows[i].rate_of(change));
        const double least = std::max(restitution_limits.least_speed * world.gravity.norm() * dt,
                                      scale_parts.least_answer * natural_length(world, *step.of_row[i]) / dt);
        pair.meets = pair.restitution > 0 && step.of_row[i]->began_open &&
                     -touching_speed(pair.impact) > least;
    }
    island.response = response_of(island);
    return island;
}

}  // namespace enduring
