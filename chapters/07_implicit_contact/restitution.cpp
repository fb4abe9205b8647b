#include "chapters/07_implicit_contact/restitution.hpp"

#include "chapters/07_implicit_contact/generalized_reflection.hpp"
#include "chapters/07_implicit_contact/step_problem.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/natural_units.hpp"
#include "common/simulation/rigid_body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

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

namespace {

/// A pair that carried an impulse in this step.
struct Struck {
    PairImpact impact;
    Vec3 normal = Vec3::UnitY();
    Vec3 velocity = Vec3::Zero();         ///< of p against q, behind the commit [m/s]
    Vec3 velocity_driven = Vec3::Zero();  ///< the part of bodies that do not answer
    Vec3 running = Vec3::Zero();          ///< of the surfaces [m/s]
    double restitution = 0, mu = 0;
    bool meets = false;  ///< was open at the start, and met faster than what rests does
};

/// Whether a pair carried an impulse, and not what rounding leaves of none.
bool has_pushed(const World& world, const Contact& contact, double dt)
{
    return contact.answered() && contact.is_spring() && contact.stiffness > 0 &&
           contact.impulse.norm() >
               contact.stiffness * dt * restitution_limits.least_length * natural_length(world, contact);
}

Struck struck(const World& world, const Contact& contact, double dt)
{
    Struck one;
    one.normal = contact.impulse.normalized();
    one.restitution = pair_restitution(world, contact);
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const Body& body = body_of_vertex(world, contact, i);
        const auto vertex = static_cast<std::size_t>(i);
        const double weight = contact.kind == ContactKind::vertex_plane ? 1 : contact.weights[vertex];
        const Vec3 velocity = weight * body.velocity(contact.vertices[vertex]);
        one.velocity += velocity;
        if (body.is_static())
            one.velocity_driven += velocity;
    }
    one.impact.dt = dt;
    one.impact.pressed = contact.impulse.norm() / (contact.stiffness * dt);
    one.impact.gap_t0 = -one.impact.pressed - dt * one.normal.dot(one.velocity);
    return one;
}

/// Whether its surfaces were apart at the start of the step, or just touched. What was pressed then rests, or is an impact of an earlier step.
bool was_open(const World& world, const Contact& contact, const Struck& pair)
{
    return pair.impact.gap_t0 > -restitution_limits.least_length * natural_length(world, contact);
}

/// Of an island, the pairs that pushed and their bodies. Empty where none of them can bounce.
Island struck_part(const World& world, const Island& island, double dt)
{
    Island part;
    bool any_meets = false;
    for (Contact* const contact : island.contacts) {
        if (!has_pushed(world, *contact, dt))
            continue;
        part.contacts.push_back(contact);
        for (int i = 0; i < contact->vertex_count(); ++i)
            part.bodies.push_back(static_cast<int>(body_index(*contact, i)));
        const Struck one = struck(world, *contact, dt);
        any_meets = any_meets || (one.restitution > 0 && was_open(world, *contact, one));
    }
    if (!any_meets)
        return {};
    std::sort(part.bodies.begin(), part.bodies.end());
    part.bodies.erase(std::unique(part.bodies.begin(), part.bodies.end()), part.bodies.end());
    part.bodies.erase(
        std::remove_if(part.bodies.begin(), part.bodies.end(),
                       [&](int body) { return world.bodies[static_cast<std::size_t>(body)]->is_static(); }),
        part.bodies.end());
    return part;
}

/// An island's impact: its pairs, and the coordinates of its bodies behind the commit.
struct IslandImpact {
    StepProblem step;
    std::vector<Struck> pairs;  ///< of each row
    VectorXd gravity;           ///< as acceleration of the coordinates
    VectorXd momentum;          ///< of all impulses of the step
    double lost = 0;            ///< kinetic energy that these impulses took away [J]
    MatrixXd response;          ///< W, of velocities along the normals
};

/// What gravity does to each coordinate.
VectorXd gravity_on(const World& world, const StepProblem& step)
{
    VectorXd all = VectorXd::Zero(step.problem.size);
    for (std::size_t place = 0; place < step.bodies.size(); ++place) {
        if (step.block[place] < 0)
            continue;
        const Body& body = *world.bodies[static_cast<std::size_t>(step.bodies[place])];
        const BodyBlock& block = step.problem.blocks[static_cast<std::size_t>(step.block[place])];
        const Vec3 gravity = body.gravity_on(world.gravity);
        if (body.contact_motion(step.vertices[place], 0, 0).rate.cols() == 6) {  // of a rigid body
            all.segment<3>(block.first) = gravity;
            if (const auto* const rigid = dynamic_cast<const RigidBody*>(&body))
                all.segment<3>(block.first + 3) = rigid->motion().angular_acceleration(gravity);
        } else {
            for (int i = 0; i < block.size(); i += 3)
                all.segment<3>(block.first + i) = gravity;
        }
    }
    return all;
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

/// Masses and levers are those behind the commit.
IslandImpact impact_of(const World& world, const Island& part, const FrictionCoefficients& friction,
                       double dt)
{
    IslandImpact island;
    island.step = set_up(world, part, {}, friction, {0, dt}, false);
    const StepProblem& step = island.step;
    island.gravity = gravity_on(world, step);
    island.momentum = VectorXd::Zero(step.problem.size);
    double work = 0;
    for (std::size_t i = 0; i < step.of_row.size(); ++i) {
        const Contact& contact = *step.of_row[i];
        island.pairs.push_back(struck(world, contact, dt));
        if (step.problem.rows[i].law.mu > 0)
            island.pairs.back().mu = pair_friction(world, contact, friction).mu_d;
        island.pairs.back().running = running_of_surfaces(world, contact);
        const Vec3 impulse = contact.impulse + contact.friction;
        step.problem.rows[i].add_impulse(impulse, island.momentum);
        work += impulse.dot(island.pairs.back().velocity);
    }
    const VectorXd change = times_response(step.problem, island.momentum);
    island.lost = island.momentum.dot(change) / 2 - work;
    for (std::size_t i = 0; i < island.pairs.size(); ++i) {
        Struck& pair = island.pairs[i];
        const PairRow& row = step.problem.rows[i];
        pair.impact.free_speed = pair.normal.dot(pair.velocity - row.rate_of(change));
        pair.impact.acceleration = pair.normal.dot(row.rate_of(island.gravity));
        const double least = std::max(restitution_limits.least_speed * world.gravity.norm() * dt,
                                      scale_parts.least_answer * natural_length(world, *step.of_row[i]) / dt);
        pair.meets = pair.restitution > 0 && was_open(world, *step.of_row[i], pair) &&
                     -touching_speed(pair.impact) > least;
    }
    island.response = response_of(island);
    return island;
}

//! [leaving]
/// The velocities of the pairs behind the impact, at touch [m/s]: between those without restitution and those with all of it, each
/// pair's impulse by its own coefficient. Those that were in touch before do not approach at first.
/// @param impulses  receives what the pairs get
VectorXd leaving_velocities(const IslandImpact& island, VectorXd& impulses)
{
    const auto count = static_cast<Eigen::Index>(island.pairs.size());
    VectorXd touching(count), restitution(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Struck& pair = island.pairs[static_cast<std::size_t>(i)];
        touching[i] = pair.meets ? touching_speed(pair.impact) : std::max(0.0, pair.impact.free_speed);
        restitution[i] = pair.restitution;
    }
    const VectorXd stopping = stopping_impulses(island.response, touching);
    const VectorXd reflecting = reflecting_impulses(island.response, touching);
    impulses = stopping + restitution.cwiseProduct(reflecting - stopping);
    return touching + island.response * impulses;
}
//! [leaving]

/// Those pairs that bounce, and the velocity along its normal with which each ends the step [m/s].
struct Bounce {
    std::vector<Eigen::Index> pairs;
    VectorXd speeds;
};

Bounce bounce_of(const IslandImpact& island)
{
    VectorXd impulses;
    const VectorXd leaving = leaving_velocities(island, impulses);
    const double least = 1e-9 * impulses.cwiseAbs().maxCoeff();
    Bounce bounce;
    std::vector<double> speeds;
    for (Eigen::Index i = 0; i < leaving.size(); ++i) {
        const Struck& pair = island.pairs[static_cast<std::size_t>(i)];
        if (!(pair.restitution > 0 && impulses[i] > least))
            continue;
        bounce.pairs.push_back(i);
        const double speed = std::max(0.0, leaving[i]);
        speeds.push_back(pair.meets ? speed_after(pair.impact, speed) : speed);
    }
    bounce.speeds = Eigen::Map<const VectorXd>(speeds.data(), static_cast<Eigen::Index>(speeds.size()));
    return bounce;
}

/// The impulses, of all pairs, that bring those that bounce to their speeds. Where more pairs meet than bodies can tell apart, the
/// smallest ones that do.
VectorXd impulses_for(const IslandImpact& island, const Bounce& bounce)
{
    if (bounce.pairs.empty())
        return VectorXd::Zero(static_cast<Eigen::Index>(island.pairs.size()));
    const auto count = static_cast<Eigen::Index>(bounce.pairs.size());
    MatrixXd response(count, count);
    VectorXd missing(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Struck& pair = island.pairs[static_cast<std::size_t>(bounce.pairs[at])];
        missing[i] = bounce.speeds[i] - pair.normal.dot(pair.velocity);
        for (Eigen::Index j = 0; j < count; ++j)
            response(i, j) = island.response(bounce.pairs[at], bounce.pairs[static_cast<std::size_t>(j)]);
    }
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> factor;
    factor.setThreshold(1e-6);  // of the largest response; where masses differ more, the lighter body decides
    factor.compute(response);
    const VectorXd solved = factor.solve(missing);
    VectorXd all = VectorXd::Zero(static_cast<Eigen::Index>(island.pairs.size()));
    for (Eigen::Index i = 0; i < count; ++i)
        all[bounce.pairs[static_cast<std::size_t>(i)]] = solved[i];
    return all;
}

/// A pair that leaves holds nothing any more.
void let_go(Contact& contact)
{
    contact.load = 0;
    contact.stretch.setZero();
}

//! [rub]
/// What acts on the pairs of an island to send them back.
struct SendingBack {
    VectorXd impulses;           ///< along the normals [N s]
    std::vector<Vec3> friction;  ///< [N s]
    VectorXd momentum;           ///< of both
    double slope = 0;            ///< impulses . velocities before [J]
    double driven = 0;           ///< work of bodies that move as given, and of surfaces that run [J]
};

void add_push(const IslandImpact& island, std::size_t pair, const Vec3& impulse, SendingBack& back)
{
    island.step.problem.rows[pair].add_impulse(impulse, back.momentum);
    back.slope += impulse.dot(island.pairs[pair].velocity);
    back.driven -= impulse.dot(island.pairs[pair].velocity_driven);
}

/// Friction of the impulses along the normals, against the slip at the moment at which the pairs that bounce are stopped: no more than
/// mu times the impulse of its pair, and no more than stops it.
void rub(const IslandImpact& island, const Bounce& bounce, SendingBack& back)
{
    const StepProblem& step = island.step;
    const VectorXd stopping = impulses_for(
        island, {bounce.pairs, VectorXd::Zero(static_cast<Eigen::Index>(bounce.pairs.size()))});
    VectorXd stopped = VectorXd::Zero(step.problem.size);
    for (std::size_t i = 0; i < island.pairs.size(); ++i)
        step.problem.rows[i].add_impulse(stopping[static_cast<Eigen::Index>(i)] * island.pairs[i].normal,
                                         stopped);
    VectorXd change = times_response(step.problem, stopped);
    for (int sweep = 0; sweep < restitution_limits.friction_sweeps; ++sweep)
        for (std::size_t i = 0; i < island.pairs.size(); ++i) {
            const Struck& pair = island.pairs[i];
            const double limit = pair.mu * back.impulses[static_cast<Eigen::Index>(i)];
            if (!(limit > 0))
                continue;
            const PairRow& row = step.problem.rows[i];
            const Mat3 along = Mat3::Identity() - pair.normal * pair.normal.transpose();
            const Vec3 slip = along * (pair.velocity + pair.running + row.rate_of(change));
            const double largest = (along * row.response(step.problem.blocks) * along).operatorNorm();
            Vec3 next = back.friction[i] - slip / largest;
            if (next.norm() > limit)
                next *= limit / next.norm();
            VectorXd added = VectorXd::Zero(step.problem.size);
            row.add_impulse(next - back.friction[i], added);
            change += times_response(step.problem, added);
            back.friction[i] = next;
        }
    for (std::size_t i = 0; i < island.pairs.size(); ++i) {
        add_push(island, i, back.friction[i], back);
        back.driven -= back.friction[i].dot(island.pairs[i].running);
    }
}
//! [rub]

//! [send_back]
void send_back(World& world, IslandImpact& island, const Bounce& bounce, double dt)
{
    SendingBack back{impulses_for(island, bounce), std::vector<Vec3>(island.pairs.size(), Vec3::Zero()),
                     VectorXd::Zero(island.step.problem.size)};
    for (std::size_t i = 0; i < island.pairs.size(); ++i)
        add_push(island, i, back.impulses[static_cast<Eigen::Index>(i)] * island.pairs[i].normal, back);
    rub(island, bounce, back);
    // What steps keep in a fall is E + dt / 2 g . p, with the momentum p: of this nothing is gained.
    const double of_step = dt / 2 * island.gravity.dot(island.momentum),
                 of_this = dt / 2 * island.gravity.dot(back.momentum);
    const double curvature = back.momentum.dot(times_response(island.step.problem, back.momentum));
    const double part = allowed_part(back.slope + of_this, curvature, island.lost + of_step);
    for (std::size_t i = 0; i < island.pairs.size(); ++i) {
        Contact& contact = *island.step.of_row[i];
        contact.impulse += part * back.impulses[static_cast<Eigen::Index>(i)] * island.pairs[i].normal;
        contact.friction += part * back.friction[i];
    }
    for (const Eigen::Index pair : bounce.pairs)
        let_go(*island.step.of_row[static_cast<std::size_t>(pair)]);
    kick(world, island.step, part * back.momentum);
    world.driven += part * back.driven;
    world.attempt.put_in += part * back.driven + std::max(0.0, -of_step - part * of_this);
}
//! [send_back]

}  // namespace

//! [restitute]
void restitute(World& world, Contacts& contacts, const FrictionCoefficients& friction, double dt)
{
    if (!world.restitution.any())
        return;
    for (const Island& island : find_islands(world, contacts)) {
        const Island part = struck_part(world, island, dt);
        if (part.contacts.empty())
            continue;
        IslandImpact impact = impact_of(world, part, friction, dt);
        const bool any_meets = std::any_of(impact.pairs.begin(), impact.pairs.end(),
                                           [](const Struck& pair) { return pair.meets; });
        if (!any_meets)
            continue;
        const Bounce bounce = bounce_of(impact);
        if (!bounce.pairs.empty())
            send_back(world, impact, bounce, dt);
    }
}
//! [restitute]

}  // namespace enduring
