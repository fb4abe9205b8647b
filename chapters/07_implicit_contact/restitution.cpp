#include "chapters/07_implicit_contact/restitution.hpp"

#include "chapters/07_implicit_contact/generalized_reflection.hpp"
#include "chapters/07_implicit_contact/island_impact.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace enduring {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

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
    VectorXd all = VectorXd::Zero(static_cast<Eigen::Index>(island.pairs.size()));
    if (bounce.pairs.empty())
        return all;
    VectorXd missing = bounce.speeds;
    for (Eigen::Index i = 0; i < missing.size(); ++i) {
        const Struck& pair =
            island.pairs[static_cast<std::size_t>(bounce.pairs[static_cast<std::size_t>(i)])];
        missing[i] -= pair.normal.dot(pair.velocity);
    }
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> factor;
    factor.setThreshold(1e-6);  // of the largest response; where masses differ more, the lighter body decides
    factor.compute(island.response(bounce.pairs, bounce.pairs));
    all(bounce.pairs) = VectorXd(factor.solve(missing));
    return all;
}

/// The two bodies of a pair, the smaller number first; a plane has one below zero.
std::pair<int, int> bodies_of(const Contact& contact)
{
    const int other = contact.kind == ContactKind::vertex_plane ? -1 - contact.body_b : contact.body_b;
    return std::minmax({contact.body_a, other});
}

/// Where a pair bounces, all pairs of its two bodies hold nothing any more: the impact is over, and all of it is in the velocities.
void let_go(const IslandImpact& island, const Bounce& bounce)
{
    std::set<std::pair<int, int>> leaving;
    for (const Eigen::Index pair : bounce.pairs)
        leaving.insert(bodies_of(*island.step.of_row[static_cast<std::size_t>(pair)]));
    for (Contact* const contact : island.step.of_row)
        if (leaving.count(bodies_of(*contact)) > 0) {
            contact->load = 0;
            contact->stretch.setZero();
        }
}

//! [rub]
/// What acts on the pairs of an island to send them back.
struct SendingBack {
    VectorXd impulses;           ///< along the normals [N s]
    std::vector<Vec3> friction;  ///< [N s]
    VectorXd momentum;           ///< of both
    double slope = 0;            ///< impulses . velocities before, with surfaces that run [J]
    double fall = 0;             ///< g . p of these impulses [J/s]
    double driven = 0;           ///< work of bodies that move as given, and of surfaces that run [J]
};

void add_push(const IslandImpact& island, std::size_t pair, const Vec3& impulse, SendingBack& back)
{
    island.step.problem.rows[pair].add_impulse(impulse, back.momentum);
    back.slope += impulse.dot(island.pairs[pair].velocity);
    back.fall += impulse.dot(island.pairs[pair].acceleration);
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
        const double against_running = back.friction[i].dot(island.pairs[i].running);
        back.slope += against_running;
        back.driven -= against_running;
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
    const double of_step = dt / 2 * island.fall, of_this = dt / 2 * back.fall;
    const double curvature = back.momentum.dot(times_response(island.step.problem, back.momentum));
    const double part = allowed_part(back.slope + of_this, curvature, island.lost + of_step);
    for (std::size_t i = 0; i < island.pairs.size(); ++i) {
        Contact& contact = *island.step.of_row[i];
        contact.impulse += part * back.impulses[static_cast<Eigen::Index>(i)] * island.pairs[i].normal;
        contact.friction += part * back.friction[i];
    }
    let_go(island, bounce);
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
