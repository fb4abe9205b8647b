#include "chapters/07_implicit_contact/restitution.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace enduring {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

//! [leaving]
/// The velocities of the pairs behind the impact, at touch [m/s]: between those without restitution and those
/// with all of it, each pair's impulse by its own coefficient. Those that were in touch before do not
/// approach at first.
/// @param impulses  receives what the pairs get
VectorXd leaving_velocities(const IslandImpact& island, VectorXd& impulses)
{
    const auto count = static_cast<Eigen::Index>(island.pairs.size());
    VectorXd touching(count), restitution(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const PushedPair& pair = island.pairs[static_cast<std::size_t>(i)];
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
    const double least = 1e-9 * impulses.lpNorm<Eigen::Infinity>();
    Bounce bounce;
    std::vector<double> speeds;
    for (Eigen::Index i = 0; i < leaving.size(); ++i) {
        const PushedPair& pair = island.pairs[static_cast<std::size_t>(i)];
        if (!(pair.restitution > 0 && impulses[i] > least))
            continue;
        bounce.pairs.push_back(i);
        const double speed = std::max(0.0, leaving[i]);
        speeds.push_back(pair.meets ? speed_after(pair.impact, speed) : speed);
    }
    bounce.speeds = Eigen::Map<const VectorXd>(speeds.data(), static_cast<Eigen::Index>(speeds.size()));
    return bounce;
}

//! [impulses_for]
/// How the step's friction has turned rigid bodies that are free to move, as a change of the coordinates. Its
/// force moves them along their surfaces; its torque turns vertices beside each other up and down.
VectorXd turned_by_friction(const StepProblem& step)
{
    VectorXd momentum = VectorXd::Zero(step.problem.size);
    for (std::size_t i = 0; i < step.of_row.size(); ++i)
        for (const VertexMotion& part : step.problem.rows[i].moving()) {
            const double weight = part.rate(0, 0);
            if (part.rate.cols() == 6 && weight != 0 && part.rate.leftCols<3>() == weight * Mat3::Identity())
                momentum.segment<3>(part.first + 3) += part.rate.rightCols<3>().transpose() *
                                                       step.of_row[i]->friction;
        }
    return times_response(step.problem, momentum);
}

/// The velocities of those pairs that bounce along their normals [m/s], without what friction has turned in
/// this step: it is not the bounce's to take away.
VectorXd speeds_without_friction(const IslandImpact& island, const Bounce& bounce)
{
    const VectorXd change = turned_by_friction(island.step);
    VectorXd speeds(static_cast<Eigen::Index>(bounce.pairs.size()));
    for (Eigen::Index i = 0; i < speeds.size(); ++i) {
        const auto row = static_cast<std::size_t>(bounce.pairs[static_cast<std::size_t>(i)]);
        const PushedPair& pair = island.pairs[row];
        speeds[i] = pair.normal.dot(pair.velocity - island.step.problem.rows[row].rate_of(change));
    }
    return speeds;
}

/// The impulses, of all pairs, that bring those that bounce to their speeds; where more pairs meet than
/// bodies can tell apart, the smallest ones that do. None pulls, together with that of the step: a pair that
/// would have to gives back what it has, and the others are solved anew.
VectorXd impulses_for(const IslandImpact& island, const Bounce& bounce)
{
    VectorXd all = VectorXd::Zero(static_cast<Eigen::Index>(island.pairs.size()));
    const VectorXd missing = bounce.speeds - speeds_without_friction(island, bounce);
    std::vector<Eigen::Index> open(
        bounce.pairs.size());  // places in the bounce, of pairs whose impulses are not known yet
    std::iota(open.begin(), open.end(), 0);
    for (bool pulls = true; pulls && !open.empty();) {
        std::vector<Eigen::Index> pairs;
        pairs.reserve(open.size());
        for (const Eigen::Index place : open)
            pairs.push_back(bounce.pairs[static_cast<std::size_t>(place)]);
        Eigen::CompleteOrthogonalDecomposition<MatrixXd> factor;
        factor.setThreshold(restitution_limits.least_response);
        factor.compute(island.response(pairs, pairs));
        const VectorXd by_others = island.response(pairs, Eigen::all) * all,
                       impulses = factor.solve(VectorXd(missing(open)) - by_others);
        std::vector<Eigen::Index> pushing;
        for (Eigen::Index i = 0; i < impulses.size(); ++i) {
            const auto row = static_cast<std::size_t>(pairs[static_cast<std::size_t>(i)]);
            const double has = island.pairs[row].normal.dot(island.step.of_row[row]->impulse);
            if (impulses[i] < -has)
                all[pairs[static_cast<std::size_t>(i)]] = -has;
            else
                pushing.push_back(open[static_cast<std::size_t>(i)]);
        }
        pulls = pushing.size() < open.size();
        if (!pulls)
            all(pairs) = impulses;
        open = std::move(pushing);
    }
    return all;
}
//! [impulses_for]

/// The two bodies of a pair, the smaller number first; a plane has one below zero.
std::pair<int, int> bodies_of(const Contact& contact)
{
    const int other = contact.on_plane() ? -1 - contact.body_b : contact.body_b;
    return std::minmax({contact.body_a, other});
}

/// Where a pair bounces, all pairs of its two bodies hold nothing any more: the impact is over, and all of it
/// is in the velocities.
void let_go(const IslandImpact& island, const Bounce& bounce)
{
    std::set<std::pair<int, int>> leaving;
    for (const Eigen::Index pair : bounce.pairs)
        leaving.insert(bodies_of(*island.step.of_row[static_cast<std::size_t>(pair)]));
    for (Contact* const contact : island.step.of_row)
        if (leaving.count(bodies_of(*contact)) > 0) {
            contact->spring.load = 0;
            contact->spring.stretch.setZero();
        }
}

//! [rub]
/// Friction of the impulses along the normals, against the slip at the moment at which the pairs that bounce
/// are stopped: no more than mu times the impulse of its pair, and no more than stops it.
std::vector<Vec3> friction_of(const IslandImpact& island, const Bounce& bounce, const VectorXd& impulses)
{
    const StepProblem& step = island.step;
    const VectorXd stopping = impulses_for(
        island, {bounce.pairs, VectorXd::Zero(static_cast<Eigen::Index>(bounce.pairs.size()))});
    VectorXd stopped = VectorXd::Zero(step.problem.size);
    for (std::size_t i = 0; i < island.pairs.size(); ++i)
        step.problem.rows[i].add_impulse(stopping[static_cast<Eigen::Index>(i)] * island.pairs[i].normal,
                                         stopped);
    VectorXd change = times_response(step.problem, stopped);
    std::vector<Vec3> friction(island.pairs.size(), Vec3::Zero());
    for (int sweep = 0; sweep < restitution_limits.friction_sweeps; ++sweep)
        for (std::size_t i = 0; i < island.pairs.size(); ++i) {
            const PushedPair& pair = island.pairs[i];
            const double limit = pair.mu * impulses[static_cast<Eigen::Index>(i)];
            if (!(limit > 0))
                continue;
            const PairRow& row = step.problem.rows[i];
            const Mat3 along = Mat3::Identity() - pair.normal * pair.normal.transpose();
            const Vec3 slip = along * (pair.velocity + pair.running + row.rate_of(change));
            const double largest = (along * step.responses[i] * along).operatorNorm();
            Vec3 next = friction[i] - slip / largest;
            if (next.norm() > limit)
                next *= limit / next.norm();
            VectorXd added = VectorXd::Zero(step.problem.size);
            row.add_impulse(next - friction[i], added);
            change += times_response(step.problem, added);
            friction[i] = next;
        }
    return friction;
}
//! [rub]

//! [send_back]
void send_back(World& world, const IslandImpact& island, const Bounce& bounce, double dt)
{
    const StepProblem& step = island.step;
    const VectorXd impulses = impulses_for(island, bounce);
    const std::vector<Vec3> friction = friction_of(island, bounce, impulses);
    VectorXd momentum = VectorXd::Zero(step.problem.size);
    ImpulseWork work;
    const auto along_normal = [&](std::size_t i) {
        return Vec3(impulses[static_cast<Eigen::Index>(i)] * island.pairs[i].normal);
    };
    const auto add = [&](std::size_t i, const Vec3& impulse, const Vec3& of_friction) {
        step.problem.rows[i].add_impulse(impulse, momentum);
        work.add(island.pairs[i], impulse, of_friction);
    };
    for (std::size_t i = 0; i < island.pairs.size(); ++i)
        add(i, along_normal(i), Vec3::Zero());
    for (std::size_t i = 0; i < island.pairs.size(); ++i)
        add(i, friction[i], friction[i]);
    // What steps keep in a fall is E + dt / 2 g . p, with the momentum p: of this nothing is gained.
    const double of_step = dt / 2 * island.work.fall, of_this = dt / 2 * work.fall;
    const double curvature = momentum.dot(times_response(step.problem, momentum));
    const double part = allowed_part(work.slope + of_this, curvature, island.lost + of_step);
    for (std::size_t i = 0; i < island.pairs.size(); ++i) {
        step.of_row[i]->impulse += part * along_normal(i);
        step.of_row[i]->friction += part * friction[i];
    }
    let_go(island, bounce);
    kick(world, step, part * momentum);
    world.driven += part * work.driven;
    world.attempt.added_energy += part * work.driven + std::max(0.0, -of_step - part * of_this);
}
//! [send_back]

}  // namespace

//! [restitute]
void restitute(World& world, Contacts& contacts, const FrictionCoefficients& friction, double dt)
{
    if (!world.restitution.any())
        return;
    for (const Island& island : find_islands(world, contacts)) {
        const Island part = pushed_part(world, island, dt);
        if (part.contacts.empty())
            continue;
        const IslandImpact impact = impact_of(world, part, friction, dt);
        if (const Bounce bounce = bounce_of(impact); !bounce.pairs.empty())
            send_back(world, impact, bounce, dt);
    }
}
//! [restitute]

}  // namespace enduring
