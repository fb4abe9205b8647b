#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/machine.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enduring::chapter12 {
namespace {
namespace chain_parts {

constexpr double link_length = 0.1, link_mass = 0.1, gravity = 9.81;

/// Angles of equal links that hang between two points at the same height, from the left: with the horizontal
/// force H, the joint behind link i carries a vertical force, and a link of which both ends are pulled lies
/// along the mean of these.
std::vector<double> hanging(int links, double horizontal)
{
    std::vector<double> angles;
    for (int i = 0; i < links; ++i)
        angles.push_back(std::atan((i - (links - 1) / 2.0) * link_mass * gravity / horizontal));
    return angles;
}

struct Hanging {
    double moved = 0;  ///< largest distance of a link from where it began [m]
    double sag = 0, exact_sag = 0;
    double force_off = 0;     ///< of the reaction at the left end, as a part of it
    double vertical_off = 0;  ///< of its vertical part from half of the weight
    double error = 0;
    long halved = 0;
};

/// The chain hangs in its own equilibrium: nothing moves but what is wrong.
Hanging hang(int links, double dt, double duration)
{
    const double weight = links * link_mass * gravity, horizontal = 0.3 * weight;
    Machine machine(dt);
    Vec3 end = Vec3::Zero();
    int before = -1;
    double lowest = 0;
    for (const double angle : hanging(links, horizontal)) {
        const Vec3 next = end + link_length * Vec3(std::cos(angle), std::sin(angle), 0);
        const int link = machine.add_bar(end, next, link_mass);
        machine.add_joint(JointKind::hinge, link, before, end);
        end = next;
        before = link;
        lowest = std::min(lowest, end.y());
    }
    machine.add_joint(JointKind::hinge, before, -1, end);
    std::vector<Vec3> start;
    const World& world = machine.scene.world;
    for (const auto& body : world.bodies)
        start.push_back(body->centre());
    machine.run(duration);
    Hanging of;
    of.exact_sag = -lowest;
    double least = 0;
    for (std::size_t i = 0; i < start.size(); ++i) {
        of.moved = std::max(of.moved, (world.bodies[i]->centre() - start[i]).norm());
        least = std::min(least, world.bodies[i]->centre().y() - start[i].y());
    }
    of.sag = of.exact_sag - least;
    const Vec3 reaction = world.joints.front().force, exact(-horizontal, weight / 2, 0);
    of.force_off = (reaction - exact).norm() / exact.norm();
    of.vertical_off = std::abs(reaction.y() / (weight / 2) - 1);
    of.error = machine.worst_error();
    of.halved = world.thrown_away;
    return of;
}

struct Swinging {
    double error = 0;
    long halved = 0, bad = 0;
};

/// A chain of light links swings with a heavy cube at its end.
Swinging swing(int links, double ratio, double duration)
{
    Machine machine(0.01);
    int before = -1;
    for (int i = 0; i < links; ++i) {
        const int link = machine.add_bar(Vec3(i * link_length, 0, 0), Vec3((i + 1) * link_length, 0, 0),
                                         link_mass);
        machine.add_joint(JointKind::ball, link, before, Vec3(i * link_length, 0, 0));
        before = link;
    }
    const Vec3 end(links * link_length, 0, 0);
    const int load = machine.add_box(Vec3::Constant(0.2), ratio * link_mass, end + Vec3(0.1, 0, 0));
    machine.add_joint(JointKind::ball, load, before, end);
    machine.run(duration);
    return {machine.worst_error(), machine.scene.world.thrown_away, machine.scene.world.ended_badly};
}

}  // namespace chain_parts
}  // namespace

/// Chains: one that hangs, against its equilibrium, and one that swings with a heavy body at its end.
void chain(const RunOptions& options, Report& report)
{
    using namespace chain_parts;
    const double duration = options.quick ? 0.5 : 5;
    Table table({"links", "dt_s", "exact_sag_m", "moved_m", "force_off", "joint_error_m", "halved"});
    double error = 0, force_off = 0, moved = 0;
    for (const int links : {10, 100})
        for (const double dt : {0.01, 0.0025}) {
            const Hanging of = hang(links, dt, duration);
            table.add(
                {static_cast<long>(links), dt, of.exact_sag, of.moved, of.force_off, of.error, of.halved});
            error = std::max(error, of.error);
            force_off = std::max(force_off, of.force_off);
            moved = std::max(moved, of.moved);
        }
    report.table("chain", table);
    report.page_table("chain", table, 2);
    Table swings({"links", "mass_ratio", "joint_error_m", "halved", "ended_badly"});
    double swing_error = 0;
    for (const double ratio : {1.0, 10.0, 100.0}) {
        const Swinging of = swing(10, ratio, options.quick ? 0.2 : 1);
        swings.add({10L, ratio, of.error, of.halved, of.bad});
        swing_error = std::max(swing_error, of.error);
    }
    report.table("heavy_chain", swings);
    report.page_table("heavy_chain", swings, 2);
    report.fact("chain", "joint_error_m", error, 2);
    report.fact("chain", "force_off", force_off, 2);
    report.fact("chain", "moved_m", moved, 2);
    report.fact("chain", "swing_error_m", swing_error, 2);
}

}  // namespace enduring::chapter12
